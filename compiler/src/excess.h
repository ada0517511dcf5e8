// SPDX-License-Identifier: MIT
// What is valid GLSL, but would keep glslang busy for ever or overflow its stack.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shader.h"
#include "tokens.h"

namespace gnomon::compiler {

/// The first place of `text` where macros expand beyond all measure (each of a chain uses the one before it
/// twice, say), or where an expression has so many operators that its tree is too deep to be walked. Counted
/// from above: conditionals count as if they all held, and of a macro's definitions the longest.
[[nodiscard]] std::optional<Message> find_excess(const std::string& text);

/// The first structure with too many members, those of its members counted, without those of array elements:
/// where each of a chain holds the one before it twice, they double. Part of find_excess.
[[nodiscard]] std::optional<Message> find_large_structure(const std::vector<Token>& tokens);

}  // namespace gnomon::compiler
