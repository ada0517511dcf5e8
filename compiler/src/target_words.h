// SPDX-License-Identifier: MIT
// Words that some dialects of GLSL have and others do not.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// The first word in a line of code that the target's dialect does not have and another target's has, told:
/// "'buffer': the target has no storage blocks". What glslang says there is about what a parser without the
/// word makes of it.
[[nodiscard]] std::optional<std::string> lacking_word(std::string_view line, const Target& target);

}  // namespace gnomon::compiler
