// SPDX-License-Identifier: MIT
#include "log.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

#include "text.h"

namespace gnomon::compiler {
namespace {

std::string replace_all(std::string_view text, std::string_view from, std::string_view to) {
  std::string replaced;
  for (size_t at = text.find(from); at != text.npos; at = text.find(from)) {
    replaced.append(text.substr(0, at)).append(to);
    text.remove_prefix(at + from.size());
  }
  return replaced.append(text);
}

// Takes "0:12:" off the text: the number of the string, always 0, and the line.
std::optional<int> take_line(std::string_view& text) {
  int line = 0;
  if (!text.starts_with("0:")) return std::nullopt;
  const auto [end, error] = std::from_chars(text.data() + 2, text.data() + text.size(), line);
  const auto length = static_cast<size_t>(end - text.data());
  if (error != std::errc{} || text.substr(length, 1) != ":") return std::nullopt;
  text.remove_prefix(length + 1);
  return line;
}

// What the grammar calls a token, as a person would write it.
std::string spell_token(std::string_view token) {
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
  const auto* row = std::ranges::find(spelling, token, &Row::first);
  if (row != spelling.end()) return std::string(row->second);
  std::string keyword = "'";
  for (const char c : token) keyword += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return keyword + "'";
}

// "syntax error, unexpected INT, expecting COMMA or SEMICOLON": every word in capitals is a token.
std::string spell_tokens(std::string_view text) {
  std::string spelled;
  while (!text.empty()) {
    const auto* const end = std::ranges::find_if_not(text, is_word_character);
    const std::string_view word = text.substr(0, static_cast<size_t>(end - text.begin()));
    const bool is_token =
        word.size() > 1 && std::ranges::none_of(word, [](char c) { return c >= 'a' && c <= 'z'; });
    spelled += is_token ? spell_token(word) : std::string(word);
    text.remove_prefix(word.size());
    if (text.empty()) break;
    spelled += text.front();
    text.remove_prefix(1);
  }
  return spelled;
}

// "'=' :  cannot convert from ' temp float' to ..." with plain quotes and without storage that nobody wrote.
std::string make_readable(std::string_view text) {
  text = trim(text);
  std::string_view token;
  if (const size_t end = text.find("' : "); text.starts_with('\'') && end != text.npos) {
    token = text.substr(1, end - 1);
    text = trim(text.substr(end + 4));
  }
  std::string reason = text.starts_with("syntax error") ? spell_tokens(text) : std::string(text);
  reason = replace_all(reason, "' temp ", "'");
  reason = replace_all(reason, "' global ", "'");
  for (const std::string_view storage : {"const", "in", "out", "inout", "uniform"}) {
    reason = replace_all(reason, fmt::format("' {} ", storage), fmt::format("'{} ", storage));
  }
  if (reason == "memory exhausted") return "nested too deeply for the GLSL compiler";
  if (token.empty()) return reason;
  return token.starts_with('#') ? fmt::format("{}: {}", token, reason)
                                : fmt::format("'{}': {}", token, reason);
}

}  // namespace

Log read_log(std::string_view log) {
  Log result;
  while (!log.empty()) {
    const size_t length = std::min(log.find('\n'), log.size());
    std::string_view entry = log.substr(0, length);
    log.remove_prefix(std::min(length + 1, log.size()));

    const bool is_error = entry.starts_with("ERROR: ");
    if (!is_error && !entry.starts_with("WARNING: ")) continue;
    entry.remove_prefix(entry.find(' ') + 1);
    const auto line = take_line(entry);
    if (!line) continue;
    Message message{*line, make_readable(entry)};
    if (!is_error) {
      result.warnings.push_back(std::move(message));
    } else if (!result.error) {
      result.error = std::move(message);
    }
  }
  return result;
}

std::string first_line(std::string_view log) {
  log = trim(log);
  return std::string(trim(log.substr(0, std::min(log.find('\n'), log.size()))));
}

}  // namespace gnomon::compiler
