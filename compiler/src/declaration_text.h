// SPDX-License-Identifier: MIT
// The global declarations of a GLSL text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::compiler {

/// One declaration outside of all braces: places in the text.
struct Declaration {
  size_t begin = 0;  ///< its first character
  size_t brace = 0;  ///< its first opening brace, npos where it has none
  size_t end = 0;    ///< behind its last character
};

/// Comments and directives blank, positions as in the text.
[[nodiscard]] std::string declarations_only(std::string_view text);

/// Those of a text without comments and directives.
[[nodiscard]] std::vector<Declaration> find_declarations(std::string_view code);

/// "name" of "float name(int x)"; empty where it is no function.
[[nodiscard]] std::string_view function_name(std::string_view head);

}  // namespace gnomon::compiler
