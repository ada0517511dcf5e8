// SPDX-License-Identifier: MIT
#include "gnomon/compiler/depfile.h"

#include <cstddef>
#include <string_view>

namespace gnomon::compiler {
namespace {

// Backslashes count only before a blank or '#', where each has to be doubled.
std::string escaped(std::string_view path) {
  std::string text;
  size_t backslashes = 0;
  for (const char c : path) {
    const bool separates = c == ' ' || c == '\t' || c == '#';
    if (separates) text.append(backslashes, '\\');
    if (separates || c == ':') text += '\\';
    if (c == '$') text += '$';
    text += c;
    backslashes = c == '\\' ? backslashes + 1 : 0;
  }
  return text;
}

}  // namespace

std::string to_depfile(const std::string& target, const std::vector<std::string>& files) {
  std::string rule = escaped(target) + ":";
  std::string empty_rules;
  for (size_t i = 0; i < files.size(); ++i) {
    const std::string file = escaped(files[i]);
    rule.append(" \\\n  ").append(file);
    if (i > 0) empty_rules.append(file).append(":\n");
  }
  return rule + "\n" + empty_rules;
}

}  // namespace gnomon::compiler
