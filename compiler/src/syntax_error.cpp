// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "phrase.h"
#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

bool equal_but_for_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::ranges::equal(a, b, {}, lower, lower);
}

// The grammar calls keywords by capitals: SAMPLER2D for sampler2D.
std::string spell_keyword(std::string_view token, std::string_view line) {
  for (const Token& word : tokenize(line)) {
    if (equal_but_for_case(word.text, token)) return std::string(word.text);
  }
  std::string lower;
  for (const char c : token) lower += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return lower;
}

// What the grammar calls a token, as a person would write it.
std::string spell_token(std::string_view token, std::string_view line) {
  using Row = std::pair<std::string_view, std::string_view>;
  static constexpr std::array<Row, 47> spelling = {{
      {"IDENTIFIER", "a name"},
      {"TYPE_NAME", "a type name"},
      {"FLOATCONSTANT", "a number"},
      {"INTCONSTANT", "a number"},
      {"UINTCONSTANT", "a number"},
      {"DOUBLECONSTANT", "a number"},
      {"BOOLCONSTANT", "true or false"},
      {"STRING_LITERAL", "a string"},
      {"LEFT_PAREN", "'('"},
      {"RIGHT_PAREN", "')'"},
      {"LEFT_BRACKET", "'['"},
      {"RIGHT_BRACKET", "']'"},
      {"LEFT_BRACE", "'{'"},
      {"RIGHT_BRACE", "'}'"},
      {"DOT", "'.'"},
      {"COMMA", "','"},
      {"COLON", "':'"},
      {"SEMICOLON", "';'"},
      {"EQUAL", "'='"},
      {"BANG", "'!'"},
      {"DASH", "'-'"},
      {"TILDE", "'~'"},
      {"PLUS", "'+'"},
      {"STAR", "'*'"},
      {"SLASH", "'/'"},
      {"PERCENT", "'%'"},
      {"LEFT_ANGLE", "'<'"},
      {"RIGHT_ANGLE", "'>'"},
      {"VERTICAL_BAR", "'|'"},
      {"CARET", "'^'"},
      {"AMPERSAND", "'&'"},
      {"QUESTION", "'?'"},
      {"LEFT_OP", "'<<'"},
      {"RIGHT_OP", "'>>'"},
      {"INC_OP", "'++'"},
      {"DEC_OP", "'--'"},
      {"LE_OP", "'<='"},
      {"GE_OP", "'>='"},
      {"EQ_OP", "'=='"},
      {"NE_OP", "'!='"},
      {"AND_OP", "'&&'"},
      {"OR_OP", "'||'"},
      {"XOR_OP", "'^^'"},
      {"ADD_ASSIGN", "'+='"},
      {"SUB_ASSIGN", "'-='"},
      {"MUL_ASSIGN", "'*='"},
      {"DIV_ASSIGN", "'/='"},
  }};
  const auto* const row = std::ranges::find(spelling, token, &Row::first);
  if (row != spelling.end()) return std::string(row->second);
  return "'" + spell_keyword(token, line) + "'";
}

// The names and numbers of a line that cannot stand where they stand: behind another one, or behind a closing
// parenthesis. `before`: what the line goes on with, where that is no end of a statement.
std::vector<std::string_view> find_misplaced(std::string_view line, std::string_view before, bool is_number) {
  const auto is_value = [](const Token& token) { return is_word_character(token.text.front()); };
  std::vector<std::string_view> all;
  std::vector<std::string_view> misplaced;
  bool follows = !before.empty() && std::string_view(";{}").find(before.back()) == before.npos;
  for (const Token& token : tokenize(line)) {
    const bool is_digit = token.text.front() >= '0' && token.text.front() <= '9';
    if (is_value(token) && is_digit == is_number) {
      all.push_back(token.text);
      if (follows) misplaced.push_back(token.text);
    }
    follows = (is_value(token) && !token.is("return") && !token.is("else")) || token.is(")") || token.is("]");
  }
  return misplaced.empty() ? all : misplaced;
}

// The token with its text where only one can be meant: the grammar does not tell it.
std::string spell_found(std::string_view token, std::string_view line, std::string_view before) {
  const std::string kind = spell_token(token, line);
  if (kind != "a name" && kind != "a type name" && kind != "a number") return kind;
  const std::vector<std::string_view> found = find_misplaced(line, before, kind == "a number");
  return found.size() == 1 ? fmt::format("the {} '{}'", kind.substr(2), found.front()) : kind;
}

bool is_keyword(std::string_view token) {
  const std::string spelled = spell_token(token, {});
  return spelled.size() > 3 && spelled.front() == '\'' && is_word_character(spelled[1]);
}

// "COMMA or SEMICOLON" to "',' or ';'".
std::string spell_tokens(std::string_view tokens) {
  std::string spelled;
  while (!tokens.empty()) {
    const size_t length = std::min(tokens.find(" or "), tokens.size());
    if (!spelled.empty()) spelled += " or ";
    spelled += spell_token(trim(tokens.substr(0, length)), {});
    tokens.remove_prefix(std::min(length + 4, tokens.size()));
  }
  return spelled;
}

std::string advice(std::string_view found, std::string_view expected) {
  if (found == "end of file") return expected.empty() ? "; a '}' or ')' is missing" : "";
  const bool wants_semicolon = expected.find("SEMICOLON") != expected.npos;
  if (is_keyword(found) && wants_semicolon)
    return "; a ';' is missing before it, or a keyword is used as a name";
  if (is_keyword(found) && expected.find("IDENTIFIER") != expected.npos)
    return "; a keyword cannot be a name";
  if (wants_semicolon && found != "RIGHT_PAREN") return "; is a ';' missing before it?";
  if (expected.empty() && found == "RIGHT_BRACE")
    return "; there is one '}' too many, or a ';' is missing before it";
  if (expected.empty() && found == "SEMICOLON") return "; something is missing before it";
  return {};
}

}  // namespace

std::string spell_syntax_error(std::string_view reason, std::string_view line, std::string_view before) {
  constexpr std::string_view unexpected = "unexpected ";
  constexpr std::string_view expecting = ", expecting ";
  const size_t at = reason.find(unexpected);
  if (at == reason.npos) return std::string(reason);
  std::string_view found = reason.substr(at + unexpected.size());
  const size_t end = std::min(found.find(expecting), found.size());
  const std::string_view expected = trim(found.substr(std::min(end + expecting.size(), found.size())));
  found = trim(found.substr(0, end));

  const bool at_end = found == "end of file";
  const std::string what = at_end ? "the file ends" : "found " + spell_found(found, line, before);
  std::string where = " where ";
  if (expected.empty()) {
    where = at_end ? " too early" : ", which cannot stand here";
  } else {
    where += spell_tokens(expected) + " was expected";
  }
  return "syntax error: " + what + where + advice(found, expected);
}

}  // namespace gnomon::compiler
