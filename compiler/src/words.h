// SPDX-License-Identifier: MIT
// Names of GLSL that mean something else in the language that it is translated to.
#pragma once

#include <string_view>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// Whether a name is a keyword, a type or a function of HLSL or MSL.
[[nodiscard]] bool is_word_of(Format format, std::string_view name);

}  // namespace gnomon::compiler
