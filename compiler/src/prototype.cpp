// SPDX-License-Identifier: MIT
#include "prototype.h"

#include <algorithm>

#include "text.h"

namespace gnomon::compiler {
namespace {

// A call stands behind an operator or behind one of these words, a prototype behind the name of a type.
bool ends_in_type(std::string_view before) {
  before = trim(before);
  size_t begin = before.size();
  while (begin > 0 && is_word_character(before[begin - 1])) --begin;
  const std::string_view word = before.substr(begin);
  return is_identifier(word) && word != "return" && word != "else" && word != "do";
}

// "(...);", with parentheses inside where a macro makes the type.
bool begins_with_parameters_only(std::string_view after) {
  after = trim(after.substr(0, after.find(';') == after.npos ? 0 : after.find(';')));
  return after.starts_with('(') && after.ends_with(')') && after.find_first_of("{}") == after.npos;
}

}  // namespace

int line_of_prototype(std::string_view text, const std::string& name) {
  const std::string code = blank_comments(text);
  const std::string_view view = code;
  for (size_t at = find_word(view, name); at != view.npos; at = find_word(view, name, at + 1)) {
    const std::string_view before = view.substr(0, at);
    if (ends_in_type(before) && begins_with_parameters_only(view.substr(at + name.size()))) {
      return 1 + static_cast<int>(std::ranges::count(before, '\n'));
    }
  }
  return 0;
}

}  // namespace gnomon::compiler
