// SPDX-License-Identifier: MIT
// GLSL text cut into tokens, as far as questions about its shape need it.
#pragma once

#include <string_view>
#include <vector>

namespace gnomon::compiler {

struct Token {
  std::string_view text;  ///< a word, a number, or one other character
  int line = 0;           ///< 1-based
  bool first = false;     ///< of its line

  [[nodiscard]] bool is(std::string_view other) const { return text == other; }
};

/// The tokens of text without comments (see blank_comments), which has to outlive them.
[[nodiscard]] std::vector<Token> tokenize(std::string_view code);

}  // namespace gnomon::compiler
