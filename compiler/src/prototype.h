// SPDX-License-Identifier: MIT
// Where a text declares a function.
#pragma once

#include <string>
#include <string_view>

namespace gnomon::compiler {

/// The 1-based line of the first `TYPE name(...);` in a GLSL text, 0 where a macro hides it.
[[nodiscard]] int line_of_prototype(std::string_view text, const std::string& name);

}  // namespace gnomon::compiler
