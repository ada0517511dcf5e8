// SPDX-License-Identifier: MIT
#include "tokens.h"

#include <algorithm>

#include "text.h"

namespace gnomon::compiler {
namespace {

// A number keeps its point: 1.5 is one token.
size_t length_of_token(std::string_view text) {
  const bool is_number = text.front() >= '0' && text.front() <= '9';
  const auto belongs = [&](char c) { return is_word_character(c) || (is_number && c == '.'); };
  const auto* const end = std::ranges::find_if_not(text, belongs);
  return std::max<size_t>(static_cast<size_t>(end - text.begin()), 1);
}

}  // namespace

std::vector<Token> tokenize(std::string_view code) {
  std::vector<Token> tokens;
  int line = 1;
  bool first = true;
  while (!code.empty()) {
    size_t length = 1;
    if (code.front() == '\n') {
      ++line;
      first = true;
    } else if (!trim(code.substr(0, 1)).empty()) {
      length = length_of_token(code);
      tokens.push_back({code.substr(0, length), line, first});
      first = false;
    }
    code.remove_prefix(length);
  }
  return tokens;
}

}  // namespace gnomon::compiler
