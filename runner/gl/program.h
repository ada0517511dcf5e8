// SPDX-License-Identifier: MIT
// A linked GL program.
#pragma once

#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon::gl {

/// Move-only owner of a program of a vertex and a fragment stage.
class Program {
 public:
  /// `name` is what messages call it. Fails (kFailed) with the driver's first error line; the sources have
  /// passed the validator before, so this is a driver's own limit or fault.
  [[nodiscard]] static Result<Program> link(const std::string& name, const std::string& vertex_source,
                                            const std::string& fragment_source);

  Program(Program&& other) noexcept;
  Program& operator=(Program&& other) noexcept;
  ~Program();

  [[nodiscard]] unsigned name() const { return name_; }

 private:
  explicit Program(unsigned name) : name_(name) {}
  unsigned name_ = 0;
};

}  // namespace gnomon::gl
