// SPDX-License-Identifier: MIT
#include "declaration_text.h"

#include <algorithm>

#include "text.h"

namespace gnomon::compiler {

std::string declarations_only(std::string_view text) {
  std::string code = blank_comments(text);
  for (size_t begin = 0; begin < code.size();) {
    const size_t end = std::min(code.find('\n', begin), code.size());
    if (trim(std::string_view(code).substr(begin, end - begin)).starts_with('#'))
      std::fill(code.begin() + static_cast<std::ptrdiff_t>(begin),
                code.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    begin = end + 1;
  }
  return code;
}

std::vector<Declaration> find_declarations(std::string_view code) {
  std::vector<Declaration> found;
  Declaration current{0, code.npos, 0};
  int depth = 0;
  bool is_open = false;
  for (size_t i = 0; i < code.size(); ++i) {
    const char c = code[i];
    if (!is_open && trim(code.substr(i, 1)).empty()) continue;
    if (!is_open) current = {i, code.npos, 0};
    is_open = true;
    if (c == '{' && depth++ == 0 && current.brace == code.npos) current.brace = i;
    if (c == '}') --depth;
    const bool is_body =
        c == '}' && trim(code.substr(current.begin, current.brace - current.begin)).ends_with(')');
    if (depth > 0 || (c != ';' && !is_body)) continue;
    current.end = i + 1;
    found.push_back(current);
    is_open = false;
  }
  return found;
}

std::string_view function_name(std::string_view head) {
  head = trim(head);
  if (!head.ends_with(')') || head.find('=') != head.npos) return {};
  head = trim(head.substr(0, head.find('(')));
  size_t begin = head.size();
  while (begin > 0 && is_word_character(head[begin - 1])) --begin;
  return head.substr(begin);
}

}  // namespace gnomon::compiler
