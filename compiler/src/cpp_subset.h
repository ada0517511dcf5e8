// SPDX-License-Identifier: MIT
// The part of GLSL that is C++ too.
#pragma once

#include <optional>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// The first thing in modules that is no C++, cannot be a member there, or means something else: a float
/// without its f is a double in C++.
[[nodiscard]] std::optional<Diagnostic> find_foreign(const Assembled& assembled);

}  // namespace gnomon::compiler
