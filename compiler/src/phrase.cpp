// SPDX-License-Identifier: MIT
#include "phrase.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "similar.h"
#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// How glslang puts it, and how a person would. {0}: the token it names, {1}: what follows its words.
struct Row {
  std::string_view token;  // empty: any
  std::string_view reason;
  std::string_view text;
};

constexpr std::array<Row, 38> kRows = {{
    {"", "memory exhausted", "nested too deeply for the GLSL compiler: move the inner part into a function"},
    {"", "boolean expression expected", "a condition has to be a bool: write a comparison, such as x != 0"},
    {"", "vector swizzle selection out of range", "'.{0}': the value has fewer components"},
    {"", "not enough data provided for construction",
     "too few components for this constructor: give one for each, or a single one for all"},
    {"", "array index out of range", "array index {1} is out of range"},
    {"", "redefinition", "'{0}': redefinition: the name is taken in this scope, choose another"},
    {"main", "function already has a body",
     "'main': a second definition: a shader has one main(), and what it includes has none"},
    {"", "function already has a body",
     "'{0}': a second definition with the same parameters: remove one, or give it another name"},
    {"", "identifiers starting with \"gl_\" are reserved",
     "'{0}': names that start with gl_ are reserved by GLSL: choose another"},
    {"", "identifiers containing consecutive underscores (\"__\")",
     "'{0}': names with two underscores in a row are reserved by GLSL: choose another"},
    {"", "names beginning with \"GL_\" can't be (un)defined:",
     "{0} {1}: names that start with GL_ are reserved by GLSL: choose another"},
    {"", "names containing consecutive underscores are reserved",
     "{0}: names with two underscores in a row are reserved by GLSL: choose another"},
    {"", "Reserved word.", "'{0}': GLSL reserves this word: choose another name"},
    {"", "cannot convert return value to function return type",
     "the value that is returned has another type than the function: convert it, or correct the function's"},
    {"", "void function cannot return a value",
     "a void function cannot return a value: remove it, or give the function its type"},
    {"", "function does not return a value:",
     "function '{1}' has no return statement: every way through it has to return a value"},
    {"", "function cannot take any parameter(s)", "'{0}' cannot take parameters: write void {0}()"},
    {"", "bad expression",
     "malformed expression of #if: expected integers, defined(NAME), and operators between them"},
    {"", "undefined macro in expression not allowed in es profile",
     "#if: the macro {1} is not defined, which ESSL refuses: test defined({1}) before it, or give -D {1}=0"},
    {"", "End of line in string", "a string that does not end in its line; GLSL has no strings"},
    {"string literal", "required extension not requested:", "GLSL has no strings"},
    {"", "required extension not requested: Possible extensions include:",
     "'{0}': needs one of the extensions {1}: add an #extension line, or do without"},
    {"", "required extension not requested:", "'{0}': needs #extension {1} : require"},
    {"macro expansion", "Too few args in Macro", "macro {1}: too few arguments"},
    {"macro expansion", "Too many args in macro", "macro {1}: too many arguments"},
    {"macro expansion", "End of input in macro", "macro {1}: the ')' of its arguments is missing"},
    {"macro expansion", "unexpected '#'",
     "macro {1}: a directive stands among its arguments: end the call before it"},
    {"#define", "Macro redefined; different substitutions:",
     "macro {1}: already defined with another value, here or with -D: #undef it first, or put this into "
     "#ifndef {1}"},
    {"#define", "Macro redefined;", "macro redefined otherwise ({1}): #undef it first"},
    {"#define", "must be followed by macro name", "#define: a name has to follow"},
    {"#extension", "extension not supported:",
     "#extension {1}: there is no such extension here: correct the name, or remove the line"},
    {"#extension", "behavior not supported:",
     "#extension: '{1}' is no behaviour: expected require, enable, warn or disable"},
    {"", "maximum nesting depth exceeded", "{0}: conditionals are nested more than 64 deep"},
    {"", "there is no such layout identifier for this stage taking an assigned value",
     "layout: there is no '{0} = ...' in this stage"},
    {"", "there is no such layout identifier for this stage", "layout: there is no '{0}' in this stage"},
    {"", "overlapping use of location", "location {1} is taken: give each variable its own"},
    {"", "sampler/image types can only be used in uniform variables or function parameters:",
     "'{1}': a {0} can only be a uniform or a parameter"},
    {"", "cannot convert from", "cannot convert from {1}"},
}};

constexpr std::string_view kDirectives[] = {"include", "define", "undef",     "if",    "ifdef",
                                            "ifndef",  "elif",   "else",      "endif", "error",
                                            "version", "line",   "extension", "pragma"};

// HLSL's and C's names of what GLSL calls otherwise.
std::string glsl_name(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 4> prefixes = {
      {{"float", "vec"}, {"int", "ivec"}, {"uint", "uvec"}, {"bool", "bvec"}}};
  for (const auto& [prefix, vector] : prefixes) {
    const std::string_view size = name.substr(std::min(prefix.size(), name.size()));
    if (!name.starts_with(prefix)) continue;
    if (size == "2" || size == "3" || size == "4") return std::string(vector) + std::string(size);
    if (prefix == "float" && size.size() == 3 && size[1] == 'x' && size[0] == size[2])
      return "mat" + std::string(size.substr(0, 1));
  }
  using Pair = std::array<std::string_view, 2>;
  constexpr std::array<Pair, 6> words = {{{"lerp", "mix"},
                                          {"frac", "fract"},
                                          {"rsqrt", "inversesqrt"},
                                          {"atan2", "atan"},
                                          {"fmod", "mod"},
                                          {"mul", "*"}}};
  const auto* const row = std::ranges::find(words, name, [](const Pair& pair) { return pair[0]; });
  return row == words.end() ? std::string() : std::string((*row)[1]);
}

bool has_word(std::string_view text, std::string_view word) {
  return find_word(text, word) != text.npos;
}

// Where "name(" stands: a call or a declaration.
bool has_call(std::string_view text, std::string_view name) {
  for (size_t at = find_word(text, name); at != text.npos; at = find_word(text, name, at + 1)) {
    if (trim(text.substr(at + name.size())).starts_with('(')) return true;
  }
  return false;
}

bool is_directive(std::string_view line) {
  return trim(line).starts_with('#');
}

// Types in quotes as GLSL spells them.
std::string spell_types(std::string_view text) {
  std::string spelled;
  while (!text.empty()) {
    const size_t open = std::min(text.find('\''), text.size());
    spelled += text.substr(0, open);
    text.remove_prefix(open);
    const size_t close = text.find('\'', 1);
    if (close == text.npos) return spelled += text;
    spelled += "'" + spell_type(text.substr(1, close - 1)) + "'";
    text.remove_prefix(close + 1);
  }
  return spelled;
}

// "no operation '*' exists that takes a left-hand operand of type 'A' and a right operand of type 'B' ..."
std::string operand_types(std::string_view reason) {
  std::vector<std::string> quoted;
  for (size_t open = reason.find('\''); open != reason.npos; open = reason.find('\'', open + 1)) {
    const size_t close = std::min(reason.find('\'', open + 1), reason.size());
    quoted.push_back(spell_type(reason.substr(open + 1, close - open - 1)));
    open = close;
    if (open == reason.size()) break;
  }
  if (quoted.size() == 3)
    return fmt::format("'{}' does not take '{}' and '{}': convert one of them", quoted[0], quoted[1],
                       quoted[2]);
  return spell_types(reason);
}

// "l-value required "x" (can't modify a const)".
std::string not_modifiable(std::string_view reason) {
  constexpr std::string_view marker = "(can't modify ";
  const size_t quote = reason.find('"');
  const size_t why = reason.find(marker);
  std::string name;
  if (quote != reason.npos) name = reason.substr(quote + 1, reason.find('"', quote + 1) - quote - 1);
  if (why == reason.npos) return "cannot be modified: only a variable can";
  const std::string_view rest = reason.substr(why + marker.size());
  const std::string kind(rest.substr(0, rest.find(')')));
  if (name.empty() || name == kind) return fmt::format("{} cannot be modified: copy it to a variable", kind);
  return fmt::format("'{}' is {} and cannot be modified: copy it to a variable", name, kind);
}

const Row* find_row(std::string_view token, std::string_view reason) {
  for (const Row& row : kRows) {
    if ((row.token.empty() || row.token == token) && reason.starts_with(row.reason)) return &row;
  }
  return nullptr;
}

}  // namespace

Phrasing::Phrasing(const std::string& text) : code_(blank_comments(text)) {
  std::string_view rest = code_;
  while (!rest.empty()) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    lines_.push_back(rest.substr(0, length));
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
}

std::string_view Phrasing::line(int number) const {
  const auto index = static_cast<size_t>(number - 1);
  return number >= 1 && index < lines_.size() ? lines_[index] : std::string_view();
}

// The code before a line, blank lines and directives left out.
std::string_view Phrasing::line_before(int number) const {
  while (--number >= 1) {
    const std::string_view text = trim(line(number));
    if (!text.empty() && !is_directive(text)) return text;
  }
  return {};
}

// Where glslang has read a directive to its end before it complains, it names the line behind it.
int Phrasing::line_of_directive(const Entry& entry) const {
  const bool is_condition = entry.token == "preprocessor evaluation";
  if (!is_condition && entry.token != "#define") return entry.line;
  if (!is_directive(line(entry.line - 1))) return entry.line;
  if (!is_directive(line(entry.line))) return entry.line - 1;
  const auto matches = [&](int number) {
    std::string_view directive = trim(trim(line(number)).substr(1));
    const std::string_view name = take_word(directive);
    return is_condition ? name == "if" || name == "elif" : name == "define" && directive.empty();
  };
  // The one before is meant where it is the only candidate, or clearly ends too early.
  const std::string_view before = trim(line(entry.line - 1));
  const bool unfinished = !is_word_character(before.back()) && before.back() != ')';
  return matches(entry.line - 1) && (unfinished || !matches(entry.line)) ? entry.line - 1 : entry.line;
}

int Phrasing::earlier_declaration(std::string_view name, int before, bool is_function) const {
  for (int number = before; number >= 1; --number) {
    const std::string_view text = line(number);
    if (number == before || is_directive(text)) continue;
    if (is_function ? has_call(text, name) : has_word(text, name)) return number;
  }
  return 0;
}

std::string Phrasing::undeclared(const Entry& entry) const {
  std::string text = fmt::format("'{}': undeclared identifier", entry.token);
  if (const std::string name = glsl_name(entry.token); !name.empty())
    return fmt::format("{}; in GLSL it is {}", text, name);
  if (const std::string name = similar_word(entry.token, code_); !name.empty())
    return fmt::format("{}; did you mean '{}'?", text, name);
  if (has_word(line(entry.line), entry.token)) return text;
  for (const Token& word : tokenize(line(entry.line))) {
    if (defines(word.text, entry.token))
      return fmt::format("{}, in the expansion of the macro {}", text, word.text);
  }
  return text;
}

// Whether there is a "#define macro" with the word in what follows.
bool Phrasing::defines(std::string_view macro, std::string_view word) const {
  return std::ranges::any_of(lines_, [&](std::string_view line) {
    if (!is_directive(line)) return false;
    std::string_view rest = trim(trim(line).substr(1));
    return take_word(rest) == "define" && take_word(rest) == macro && has_word(rest, word);
  });
}

std::string Phrasing::no_overload(const Entry& entry) const {
  if (const std::string name = glsl_name(entry.token); !name.empty())
    return fmt::format("no function '{}': in GLSL it is {}", entry.token, name);
  const auto calls = [&](std::string_view text) { return has_call(text, entry.token); };
  const auto here = lines_.begin() + std::min<std::ptrdiff_t>(entry.line - 1, std::ssize(lines_));
  if (std::any_of(lines_.begin(), here, calls))
    return fmt::format(
        "no function '{0}' takes these arguments: compare their number and types with the declaration of "
        "'{0}'",
        entry.token);
  if (std::any_of(here == lines_.end() ? here : here + 1, lines_.end(), calls))
    return fmt::format(
        "no function '{}' is declared before this line: move it up, or write its prototype above",
        entry.token);
  const std::string name = similar_word(entry.token, code_);
  return fmt::format("no function '{}' takes these arguments{}", entry.token,
                     name.empty() ? ": correct the call, or include the file that defines it"
                                  : "; did you mean '" + name + "'?");
}

// glslang names every character outside of ASCII by the same number.
std::string Phrasing::unexpected_character(const Entry& entry) const {
  const bool is_ascii =
      std::ranges::all_of(entry.token, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
  if (is_ascii) return fmt::format("'{}' is no character or operator of GLSL", entry.token);
  const std::string_view text = line(entry.line);
  const auto begin = std::ranges::find_if(text, [](char c) { return static_cast<unsigned char>(c) >= 0x80; });
  const auto end = std::find_if(begin == text.end() ? begin : begin + 1, text.end(),
                                [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
  const std::string_view character(begin, end);
  return fmt::format("{}: outside of comments GLSL takes ASCII only",
                     character.empty() ? "a character that is not ASCII" : fmt::format("'{}'", character));
}

std::string Phrasing::text_of(const Entry& entry) const {
  const std::string_view reason = entry.reason;
  if (reason.starts_with("syntax error"))
    return spell_syntax_error(reason, line(entry.line), line_before(entry.line));
  if (reason.starts_with("undeclared identifier")) return undeclared(entry);
  if (reason.starts_with("no matching overloaded function found")) return no_overload(entry);
  if (reason.starts_with("no such field")) {
    const std::string name = similar_word(entry.token, code_);
    return fmt::format("'{}': {}{}", entry.token, reason,
                       name.empty() ? "" : "; did you mean '" + name + "'?");
  }
  if (reason.starts_with("unexpected token")) return unexpected_character(entry);
  if (reason.starts_with("wrong operand types")) return operand_types(reason.substr(reason.find(':') + 1));
  if (reason.starts_with("l-value required")) return not_modifiable(reason);
  if (entry.token == "#" && reason.starts_with("invalid directive:")) {
    const std::string_view name = trim(reason.substr(reason.find(':') + 1));
    const std::string meant = similar_word(name, kDirectives);
    return fmt::format("unknown directive #{}{}", name,
                       meant.empty() ? "" : "; did you mean #" + meant + "?");
  }
  if (const Row* row = find_row(entry.token, reason)) {
    std::string rest = spell_types(trim(reason.substr(row->reason.size())));
    if (rest.size() > 2 && rest.starts_with('\'') && rest.ends_with('\'') &&
        rest.find('\'', 1) == rest.size() - 1)
      rest = rest.substr(1, rest.size() - 2);
    return fmt::format(fmt::runtime(row->text), entry.token, rest);
  }
  const std::string plain = spell_types(reason);
  if (entry.token.empty()) return plain;
  return entry.token.starts_with('#') ? fmt::format("{}: {}", entry.token, plain)
                                      : fmt::format("'{}': {}", entry.token, plain);
}

Message Phrasing::message(std::string_view text, int line) const {
  Entry entry{{}, trim(text), line};
  if (const size_t end = entry.reason.find("' : "); entry.reason.starts_with('\'') && end != text.npos) {
    entry.token = entry.reason.substr(1, end - 1);
    entry.reason = trim(entry.reason.substr(end + 4));
  }
  Message message{line_of_directive(entry), text_of(entry)};
  if (entry.reason.starts_with("redefinition"))
    message.related = earlier_declaration(entry.token, line, false);
  if (entry.reason.starts_with("function already has a body"))
    message.related = earlier_declaration(entry.token, line, true);
  if (entry.reason.starts_with("overloaded functions must have the same return type")) {
    message.related = earlier_declaration(entry.token, line, true);
    message.text = fmt::format("'{}': declared before with another result: '{}'; correct the type here",
                               entry.token, trim(this->line(message.related)));
  }
  return message;
}

}  // namespace gnomon::compiler
