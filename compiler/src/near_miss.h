// SPDX-License-Identifier: MIT
// Functions that are declared and called, but not defined.
#pragma once

#include <string>

#include "shader.h"

namespace gnomon::compiler {

/// Says of the function `name` of a text that it has no definition: at the one that was meant for it, with
/// other parameters or a mistyped name, where there is one, else at its prototype.
[[nodiscard]] Message undefined_function(const std::string& name, const std::string& text,
                                         const Shader& shader);

}  // namespace gnomon::compiler
