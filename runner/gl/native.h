// SPDX-License-Identifier: MIT
// A context of the window-system library that made it. Private to gl/.
#pragma once

#include <memory>
#include <string>

namespace gnomon::gl {

class Native {
 public:
  /// What finds GL functions by name.
  using Loader = void (*(*)(const char*))();

  Native() = default;
  Native(const Native&) = delete;
  Native& operator=(const Native&) = delete;
  /// Call release() before, if it is current.
  virtual ~Native() = default;

  /// Empty on success, else what failed. No other context, of whichever library, may be current: Mesa's
  /// libraries share one place for it.
  [[nodiscard]] virtual std::string make_current() = 0;
  virtual void release() = 0;
  [[nodiscard]] virtual Loader loader() const = 0;
  /// The library and its version, "EGL 1.5, Mesa Project".
  [[nodiscard]] virtual std::string library() const = 0;
};

/// Either a context or why there is none.
struct Opened {
  std::unique_ptr<Native> native;
  std::string failure;
};

}  // namespace gnomon::gl
