// SPDX-License-Identifier: MIT
// Libraries that are opened at run time, so that everything that needs no GL works without them. Private to
// gl/.
#pragma once

#include <dlfcn.h>

#include <initializer_list>
#include <string>

namespace gnomon::gl {

/// Never closed: drivers register exit handlers, and unloading them crashes some. RTLD_LOCAL: libEGL's and
/// OSMesa's drivers export the same names.
class Library {
 public:
  /// The first of the names that can be loaded.
  explicit Library(std::initializer_list<const char*> names) {
    for (const char* name : names) {
      if (handle_) return;
      handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
      if (handle_ || !failure_.empty()) continue;
      const char* reason = dlerror();
      failure_ = std::string(name) + " cannot be loaded (" + (reason ? reason : "no reason given") + ")";
    }
    if (handle_) failure_.clear();
  }

  [[nodiscard]] bool loaded() const { return handle_ != nullptr; }
  /// Why it was not loaded.
  [[nodiscard]] const std::string& failure() const { return failure_; }

  template <class Function>
  [[nodiscard]] Function* get(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(handle_, name));
  }

 private:
  void* handle_ = nullptr;
  std::string failure_;
};

}  // namespace gnomon::gl
