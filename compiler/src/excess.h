// SPDX-License-Identifier: MIT
// What is valid GLSL, but would keep glslang busy for ever or overflow its stack.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "shader.h"
#include "tokens.h"

namespace gnomon::compiler {

/// The first place of `text` where it becomes too long (each macro of a chain uses the one before it twice,
/// say), macros use each other too deep, or an expression has so many operators that its tree is too deep to
/// be walked. Counted from above: conditionals count as if they all held, and of a macro's definitions the
/// longest.
[[nodiscard]] std::optional<Message> find_excess(const std::string& text);

/// The same of a text without macros and comments: what preprocess() makes of one that is not excessive.
/// Finds structures that are too large, too many functions, calls, cases and, for SPIR-V, numbers, and commas
/// that are operators: they make a tree as deep.
[[nodiscard]] std::optional<Message> find_depth(const std::string& preprocessed, bool becomes_spirv);

/// The first structure with too many members, those of its members counted, without those of array elements:
/// where each of a chain holds the one before it twice, they double. Or with structures too deep in it. Part
/// of find_depth.
[[nodiscard]] std::optional<Message> find_large_structure(const std::vector<Token>& tokens);

}  // namespace gnomon::compiler
