// SPDX-License-Identifier: MIT
#include "cpp_subset.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "declaration_text.h"
#include "gnomon/compiler/cpp.h"
#include "origin.h"
#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// Names that no namespace and no class can have: keywords, and macros that systems' headers define.
constexpr auto kWords = std::to_array<std::string_view>(
    {"EOF",         "NULL",         "alignas",  "alignof",   "and",      "and_eq",     "asm",
     "assert",      "auto",         "bitand",   "bitor",     "bool",     "break",      "case",
     "catch",       "char",         "char16_t", "char32_t",  "char8_t",  "class",      "co_await",
     "co_return",   "co_yield",     "compl",    "concept",   "const",    "const_cast", "consteval",
     "constexpr",   "constinit",    "continue", "decltype",  "default",  "delete",     "do",
     "double",      "dynamic_cast", "else",     "enum",      "errno",    "explicit",   "export",
     "extern",      "false",        "far",      "float",     "for",      "friend",     "goto",
     "if",          "inline",       "int",      "linux",     "long",     "mutable",    "namespace",
     "near",        "new",          "noexcept", "not",       "not_eq",   "nullptr",    "operator",
     "or",          "or_eq",        "private",  "protected", "public",   "register",   "reinterpret_cast",
     "requires",    "return",       "short",    "signed",    "sizeof",   "static",     "static_assert",
     "static_cast", "std",          "struct",   "switch",    "template", "this",       "thread_local",
     "throw",       "true",         "try",      "typedef",   "typeid",   "typename",   "union",
     "unix",        "unsigned",     "using",    "virtual",   "void",     "volatile",   "wchar_t",
     "while",       "xor",          "xor_eq"});

// Words of GLSL's declarations that C++ has not, and what to write.
struct Foreign {
  std::string_view word;
  std::string_view advice;
};
constexpr std::array kForeign = {
    Foreign{"inout", "pass the value in and return the result"},
    Foreign{"out", "write GNOMON_OUT(type), of <gnomon/core/portable.glsl>"},
    Foreign{"in", "leave it out: parameters are values"},
    Foreign{"precision", "leave it out: gnomonc gives the defaults"},
    Foreign{"uniform", "make it a parameter, or read it in a host function"},
    Foreign{"buffer", "make it a parameter, or read it in a host function"},
};

constexpr std::string_view kVariable =
    "a variable outside of functions is not C++ here: make it const, or a parameter";

// "struct S { ... } s;" declares a variable too.
bool declares_behind_braces(std::string_view code, const Declaration& declaration) {
  const std::string_view text = code.substr(declaration.begin, declaration.end - declaration.begin);
  const size_t close = text.rfind('}');
  return close != text.npos && text.ends_with(';') &&
         !trim(text.substr(close + 1, text.size() - close - 2)).empty();
}

// "1.5", "1e3", ".5": what C++ reads as a double. `at`: of the tokens.
bool is_double(const std::vector<Token>& tokens, size_t at) {
  const auto touches = [&](size_t left, size_t right) {
    return right < tokens.size() &&
           tokens[left].text.data() + tokens[left].text.size() == tokens[right].text.data();
  };
  const auto is_number = [](const Token& token) {
    return token.text.front() >= '0' && token.text.front() <= '9';
  };
  const std::string_view text = tokens[at].text;
  if (!is_number(tokens[at]) || text.starts_with("0x") || text.starts_with("0X")) return false;
  const bool follows_point = at > 0 && tokens[at - 1].is(".") && touches(at - 1, at);
  const bool has_exponent = text.ends_with('e') || text.ends_with('E');
  std::string_view last = text;
  // "1e-5f" is three tokens.
  if (has_exponent && touches(at, at + 1) && touches(at + 1, at + 2)) last = tokens[at + 2].text;
  const bool is_float = follows_point || text.find_first_of(".eE") != text.npos;
  const bool is_single =
      (last.ends_with('f') || last.ends_with('F')) && !last.ends_with("lf") && !last.ends_with("LF");
  const bool is_exponent = at >= 2 && touches(at - 1, at) && touches(at - 2, at - 1) &&
                           is_number(tokens[at - 2]) &&
                           (tokens[at - 2].text.ends_with('e') || tokens[at - 2].text.ends_with('E'));
  return is_float && !is_single && !is_exponent;
}

// "float[](" and "float[2](".
bool is_array_constructor(const std::vector<Token>& tokens, size_t at) {
  if (!is_identifier(tokens[at].text) || at + 1 >= tokens.size() || !tokens[at + 1].is("[")) return false;
  size_t close = at + 2;
  while (close < tokens.size() && !tokens[close].is("]") && !tokens[close].is(";")) ++close;
  return close + 1 < tokens.size() && tokens[close].is("]") && tokens[close + 1].is("(");
}

// Directives but for #define blank: numbers in them are whole.
std::string values_only(std::string_view text) {
  std::string code = blank_comments(text);
  for (size_t begin = 0; begin < code.size();) {
    const size_t end = std::min(code.find('\n', begin), code.size());
    std::string_view words = trim(std::string_view(code).substr(begin, end - begin));
    if (words.starts_with('#')) {
      words = trim(words.substr(1));
      if (take_word(words) != "define")
        std::fill(code.begin() + static_cast<std::ptrdiff_t>(begin),
                  code.begin() + static_cast<std::ptrdiff_t>(end), ' ');
    }
    begin = end + 1;
  }
  return code;
}

std::optional<Diagnostic> find_foreign_value(const Assembled& assembled) {
  const std::string code = values_only(assembled.text);
  const std::vector<Token> tokens = tokenize(code);
  for (size_t at = 0; at < tokens.size(); ++at) {
    if (is_double(tokens, at))
      return locate(assembled, tokens[at].line,
                    fmt::format("'{}' is a double in C++: write an f behind it", tokens[at].text));
    if (is_array_constructor(tokens, at))
      return locate(assembled, tokens[at].line,
                    "array constructors are not C++: assign the elements one by one");
  }
  return std::nullopt;
}

}  // namespace

std::optional<Diagnostic> find_foreign(const Assembled& assembled) {
  const std::string code = declarations_only(assembled.text);
  const auto fail = [&](size_t at, std::string message) {
    const auto end = code.begin() + static_cast<std::ptrdiff_t>(at);
    return locate(assembled, 1 + static_cast<int>(std::count(code.begin(), end, '\n')), std::move(message));
  };
  for (const Declaration& declaration : find_declarations(code)) {
    const size_t end = declaration.brace == code.npos ? declaration.end : declaration.brace;
    const std::string_view head = std::string_view(code).substr(declaration.begin, end - declaration.begin);
    for (size_t at = 0; at < head.size();) {
      std::string_view rest = head.substr(at);
      const std::string_view word = take_word(rest);
      const auto foreign = std::ranges::find(kForeign, word, &Foreign::word);
      if (foreign != kForeign.end())
        return fail(declaration.begin + at, fmt::format("'{}' is not C++: {}", word, foreign->advice));
      at += std::max<size_t>(word.size(), 1);
    }
    std::string_view words = head;
    const std::string_view first = take_word(words);
    if (first != "const" && declares_behind_braces(code, declaration))
      return fail(declaration.begin, std::string(kVariable));
    if (is_word_character(head.front()) && words.starts_with('(') && first != "layout")
      return fail(declaration.begin,
                  fmt::format("'{}(': what a macro declares cannot be made a member of a C++ class: write "
                              "the declaration out",
                              first));
    if (declaration.brace == code.npos && !first.empty() && first != "const" &&
        function_name(head.substr(0, head.size() - 1)).empty())
      return fail(declaration.begin, std::string(kVariable));
  }
  return find_foreign_value(assembled);
}

bool is_cpp_name(std::string_view name) {
  const bool is_reserved = name.starts_with('_') || name.find("__") != name.npos;
  return is_identifier(name) && !is_reserved && std::ranges::find(kWords, name) == kWords.end();
}

}  // namespace gnomon::compiler
