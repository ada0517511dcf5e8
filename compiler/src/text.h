// SPDX-License-Identifier: MIT
// Small questions about GLSL text, independent of the locale.
#pragma once

#include <string>
#include <string_view>

namespace gnomon::compiler {

[[nodiscard]] constexpr bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

[[nodiscard]] constexpr bool is_identifier(std::string_view text) {
  if (text.empty() || (text[0] >= '0' && text[0] <= '9')) return false;
  for (const char c : text) {
    if (!is_word_character(c)) return false;
  }
  return true;
}

/// Without blanks at both ends.
[[nodiscard]] constexpr std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\v\f\r\n";
  const size_t first = text.find_first_not_of(blanks);
  if (first == text.npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// Takes a leading identifier off `text` and the blanks after it; empty where `text` does not begin with one.
[[nodiscard]] constexpr std::string_view take_word(std::string_view& text) {
  size_t length = 0;
  while (length < text.size() && is_word_character(text[length])) ++length;
  const std::string_view word = text.substr(0, length);
  text = trim(text.substr(length));
  return word;
}

/// `line` with each comment replaced by a blank. `in_comment` carries an open block comment from line to
/// line.
[[nodiscard]] std::string without_comments(std::string_view line, bool& in_comment);

/// `text` with each character of a comment, but for line feeds, replaced by a blank: positions stay the same.
[[nodiscard]] std::string blank_comments(std::string_view text);

/// Where `word` stands in `text` as a whole word, from `from` on; npos where it does not.
[[nodiscard]] size_t find_word(std::string_view text, std::string_view word, size_t from = 0);

/// The 1-based line of the first `word` in the code of a text, comments left out; 1 where there is none.
[[nodiscard]] int line_of_word(std::string_view text, std::string_view word);

/// Where `text` stops being UTF-8 text without NUL characters; text.size() where it never does.
[[nodiscard]] size_t first_bad_byte(std::string_view text);

}  // namespace gnomon::compiler
