// SPDX-License-Identifier: MIT
#include "mutator.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "text.h"

namespace gnomon::compiler {
namespace {

// With their line feeds, so that joining them gives the text again.
std::vector<std::string> split_lines(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    lines.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return lines;
}

// Words, numbers and single other characters.
std::vector<std::string> split_tokens(std::string_view text) {
  std::vector<std::string> tokens;
  while (!text.empty()) {
    const auto* const end = std::ranges::find_if_not(text, is_word_character);
    const auto length = std::max<size_t>(static_cast<size_t>(end - text.begin()), 1);
    tokens.emplace_back(text.substr(0, length));
    text.remove_prefix(length);
  }
  return tokens;
}

std::string join(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) text += part;
  return text;
}

// What damages a parser more than a random word does.
constexpr std::array<std::string_view, 40> kTokens = {
    "(",       ")",          "{",       "}",        "[",        "]",         ";",        ",",
    "#",       "##",         "\\\n",    "/*",       "*/",       "//",        "\"",       "#if 1\n",
    "#else\n", "#endif\n",   "#elif\n", "#define ", "#undef ",  "#version ", "#line ",   "#extension ",
    "layout",  "2147483648", "-1",      "1e999",    "struct ",  "uniform ",  "const ",   "precise ",
    "void",    "sampler2D",  "buffer",  "return ",  "while(1)", "switch",    "defined(", "__LINE__"};

}  // namespace

std::string Mutator::mutate(std::string text) {
  for (size_t left = 1 + below(8); left > 0; --left) {
    switch (below(6)) {
      case 0:
        mutate_bytes(text);
        break;
      case 1:
        mutate_lines(text);
        break;
      case 2:
        mutate_includes(text);
        break;
      case 3:
        splice(text);
        break;
      default:
        mutate_tokens(text);
        break;
    }
  }
  return text;
}

void Mutator::mutate_bytes(std::string& text) {
  if (text.empty()) return;
  const size_t at = below(text.size());
  switch (below(8)) {
    case 0:
      text.resize(at);
      break;
    case 1:
    case 2:
      text.erase(at, 1 + below(4));
      break;
    case 3:
      text.insert(at, 1 + below(3), static_cast<char>(below(256)));
      break;
    case 4:  // stays ASCII, so that more than the check for UTF-8 sees it
    case 5:
      text.insert(at, 1, static_cast<char>(' ' + below(95)));
      break;
    case 6:
      text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
      break;
    default:
      text[at] = static_cast<char>(' ' + below(95));
      break;
  }
}

void Mutator::mutate_lines(std::string& text) {
  std::vector<std::string> lines = split_lines(text);
  if (lines.empty()) return;
  const size_t at = below(lines.size());
  const size_t other = below(lines.size());
  switch (below(4)) {
    case 0:
      lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(at));
      break;
    case 1:
      lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(other), std::string(lines[at]));
      break;
    case 2:
      if (lines[at].ends_with('\n')) lines[at].insert(lines[at].size() - 1, "\\");
      break;
    default:
      std::swap(lines[at], lines[other]);
      break;
  }
  text = join(lines);
}

void Mutator::mutate_includes(std::string& text) {
  std::vector<std::string> lines = split_lines(text);
  std::vector<size_t> includes;
  for (size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].starts_with("#include")) includes.push_back(i);
  }
  const std::string fresh = "#include " + names_[below(names_.size())] + "\n";
  if (includes.empty() || below(3) == 0) {
    lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(below(lines.size() + 1)), fresh);
  } else if (below(2) == 0) {
    lines[includes[below(includes.size())]] = fresh;
  } else {
    for (size_t i = includes.size(); i > 1; --i) std::swap(lines[includes[i - 1]], lines[includes[below(i)]]);
  }
  text = join(lines);
}

void Mutator::mutate_tokens(std::string& text) {
  std::vector<std::string> tokens = split_tokens(text);
  if (tokens.empty()) return;
  const size_t at = below(tokens.size());
  const size_t other = below(tokens.size());
  switch (below(5)) {
    case 0:
      tokens[at] = tokens[other];
      break;
    case 1:
      tokens[at] = kTokens[below(kTokens.size())];
      break;
    case 2:
      tokens[at] += kTokens[below(kTokens.size())];
      break;
    case 3:
      tokens[at].clear();
      break;
    default:
      std::swap(tokens[at], tokens[other]);
      break;
  }
  text = join(tokens);
}

void Mutator::splice(std::string& text) {
  const std::string& donor = donors_[below(donors_.size())];
  if (donor.empty()) return;
  const std::string chunk = donor.substr(below(donor.size()), 1 + below(200));
  const size_t at = below(text.size() + 1);
  text.replace(at, below(2) == 0 ? 0 : chunk.size(), chunk);
}

}  // namespace gnomon::compiler
