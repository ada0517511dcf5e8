// SPDX-License-Identifier: MIT
// The part of a reflection that glslang does not know.
#pragma once

#include "shader.h"

namespace gnomon::compiler {

/// The interface of the shader, with its host functions and the options of the modules in it. `library`: the
/// folder of <gnomon/...>.
[[nodiscard]] Reflection complete_reflection(const Shader& shader, const Assembled& source, Stage stage,
                                             const Target& target, const std::string& library);

}  // namespace gnomon::compiler
