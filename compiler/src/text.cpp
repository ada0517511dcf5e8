// SPDX-License-Identifier: MIT
#include "text.h"

#include <algorithm>

namespace gnomon::compiler {
namespace {

// Length of the UTF-8 character at the front of `text`, 0 where there is none (RFC 3629: no overlong forms,
// no surrogates, nothing above U+10FFFF).
size_t character_length(std::string_view text) {
  const auto byte = [&](size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return lead == 0 ? 0 : 1;
  if (lead < 0xC2 || lead > 0xF4) return 0;
  const size_t length = lead < 0xE0 ? 2 : (lead < 0xF0 ? 3 : 4);
  for (size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  const unsigned second = byte(1);
  const bool out_of_range = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                            (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
  return out_of_range ? 0 : length;
}

}  // namespace

size_t first_bad_byte(std::string_view text) {
  size_t at = 0;
  while (at < text.size()) {
    const size_t length = character_length(text.substr(at));
    if (length == 0) break;
    at += length;
  }
  return at;
}

std::string blank_comments(std::string_view text) {
  enum class In { kCode, kLine, kBlock, kQuotes } in = In::kCode;
  std::string code(text);
  for (size_t i = 0; i < text.size(); ++i) {
    const std::string_view two = text.substr(i, 2);
    if (text[i] == '\n' && in != In::kBlock) in = In::kCode;
    if (in == In::kCode && text[i] == '"') {
      in = In::kQuotes;
    } else if (in == In::kQuotes && text[i] == '"') {
      in = In::kCode;
    } else if (in == In::kCode && (two == "//" || two == "/*")) {
      in = two == "//" ? In::kLine : In::kBlock;
      code[i++] = ' ';
      code[i] = ' ';
    } else if (in == In::kBlock && two == "*/") {
      in = In::kCode;
      code[i++] = ' ';
      code[i] = ' ';
    } else if ((in == In::kLine || in == In::kBlock) && text[i] != '\n') {
      code[i] = ' ';
    }
  }
  return code;
}

size_t find_word(std::string_view text, std::string_view word, size_t from) {
  if (word.empty()) return text.npos;
  for (size_t at = text.find(word, from); at != text.npos; at = text.find(word, at + 1)) {
    const size_t end = at + word.size();
    const bool begins = at == 0 || !is_word_character(text[at - 1]);
    if (begins && (end == text.size() || !is_word_character(text[end]))) return at;
  }
  return text.npos;
}

int line_of_word(std::string_view text, std::string_view word) {
  const std::string code = blank_comments(text);
  const size_t at = find_word(code, word);
  if (at == code.npos) return 1;
  return 1 + static_cast<int>(std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

std::string without_comments(std::string_view line, bool& in_comment) {
  std::string code;
  bool in_quotes = false;  // of #include "a//b.glsl"
  for (size_t i = 0; i < line.size(); ++i) {
    const std::string_view two = line.substr(i, 2);
    if (in_comment) {
      if (two == "*/") {
        in_comment = false;
        ++i;
      }
    } else if (!in_quotes && two == "//") {
      break;
    } else if (!in_quotes && two == "/*") {
      in_comment = true;
      code += ' ';
      ++i;
    } else {
      if (line[i] == '"') in_quotes = !in_quotes;
      code += line[i];
    }
  }
  return code;
}

}  // namespace gnomon::compiler
