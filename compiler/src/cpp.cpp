// SPDX-License-Identifier: MIT
#include "gnomon/compiler/cpp.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "assemble.h"
#include "origin.h"
#include "shader.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

// Comments and directives blank, positions as in the text.
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

// One declaration outside of all braces.
struct Declaration {
  size_t begin = 0;  // its first character
  size_t brace = 0;  // its first opening brace, npos where it has none
  size_t end = 0;    // behind its last character
};

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

// "name" of "float name(int x)"; empty where it is no function.
std::string_view function_name(std::string_view head) {
  head = trim(head);
  if (!head.ends_with(')') || head.find('=') != head.npos) return {};
  head = trim(head.substr(0, head.find('(')));
  size_t begin = head.size();
  while (begin > 0 && is_word_character(head[begin - 1])) --begin;
  return head.substr(begin);
}

// The type in "highp vec2 name[3]": what tells overloads apart, up to blanks.
std::string parameter_type(std::string_view parameter) {
  std::string type;
  std::string last;
  while (!(parameter = trim(parameter)).empty()) {
    std::string_view rest = parameter;
    const std::string_view word = take_word(rest);
    const bool is_qualifier = word == "const" || word == "highp" || word == "mediump" || word == "lowp";
    if (!is_qualifier) {
      type += last;
      last = word.empty() ? parameter.substr(0, 1) : word;
    }
    parameter.remove_prefix(word.empty() ? 1 : word.size());
  }
  // The last word is the name, where there is one.
  return type.empty() ? last : type;
}

// "name(vec2,int)" of "float name(vec2 x, int y)".
std::string signature_of(std::string_view head) {
  std::string signature(function_name(head));
  const size_t open = head.find('(');
  if (signature.empty() || open == head.npos) return signature;
  int depth = 0;
  size_t begin = open + 1;
  for (size_t i = open; i < head.size(); ++i) {
    if (head[i] == '(') ++depth;
    if (head[i] == ')') --depth;
    if ((head[i] != ',' || depth > 1) && depth > 0) continue;
    signature += "," + parameter_type(head.substr(begin, i - begin));
    begin = i + 1;
    if (depth == 0) break;
  }
  return signature;
}

// What makes a member of a declaration: texts to insert and places to blank.
class Members {
 public:
  explicit Members(std::string& text) : text_(text), code_(declarations_only(text)) {}

  void rewrite() {
    const std::vector<Declaration> declarations = find_declarations(code_);
    for (const Declaration& declaration : declarations) {
      if (declaration.brace != code_.npos) defined_.insert(signature_of(head_of(declaration)));
    }
    for (const Declaration& declaration : declarations) rewrite(declaration);
    // From the end, so that the places before stay.
    std::ranges::stable_sort(insertions_, {}, &std::pair<size_t, std::string>::first);
    for (auto it = insertions_.rbegin(); it != insertions_.rend(); ++it) text_.insert(it->first, it->second);
  }

 private:
  [[nodiscard]] std::string_view head_of(const Declaration& d) const {
    const size_t end = d.brace == code_.npos ? d.end - 1 : d.brace;
    return std::string_view(code_).substr(d.begin, end - d.begin);
  }

  void rewrite(const Declaration& declaration) {
    const std::string_view head = head_of(declaration);
    if (function_name(head).empty()) {
      std::string_view words = trim(head);
      if (take_word(words) == "const") insertions_.emplace_back(declaration.begin, "static inline ");
    } else if (declaration.brace != code_.npos) {
      insertions_.emplace_back(declaration.brace, "const ");
    } else if (!defined_.insert(signature_of(head))
                    .second) {  // a class takes no second declaration of a member
      for (size_t i = declaration.begin; i < declaration.end; ++i) {
        if (text_[i] != '\n') text_[i] = ' ';
      }
    } else {
      insertions_.emplace_back(declaration.begin, "virtual ");
      insertions_.emplace_back(declaration.end - 1, " const" + absent_body(declaration));
    }
  }

  // What a host function does that the derived class does not define.
  [[nodiscard]] std::string absent_body(const Declaration& declaration) {
    const std::string_view head = head_of(declaration);
    std::string_view words = trim(head);
    if (take_word(words) != "GNOMON_OPTIONAL") return " = 0";
    text_[declaration.end - 1] = ' ';  // no semicolon behind a body
    return fmt::format(
        R"( {{ std::fputs("gnomon: a module asks for {}, which this class of yours does not define\n", stderr); std::terminate(); }})",
        function_name(head));
  }

  std::string& text_;
  const std::string code_;
  std::set<std::string> defined_;  // or declared, by signature
  std::vector<std::pair<size_t, std::string>> insertions_;
};

std::string literal_path(const std::string& path) {
  std::string literal;
  for (const char c : path) literal += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return literal;
}

// A #line wherever the next line is not the one that follows the last in the same file.
std::string with_origins(const Assembled& assembled, const std::string& library) {
  std::string text;
  LineOrigin last{-1, 0};
  std::string_view rest = assembled.text;
  for (const LineOrigin& origin : assembled.origins) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.starts_with("#version")) continue;
    if (origin.line > 0 && (origin.inclusion != last.inclusion || origin.line != last.line + 1)) {
      text +=
          fmt::format("#line {} \"{}\"\n", origin.line,
                      literal_path(portable_name(file_of(assembled, origin.inclusion), assembled, library)));
    }
    text.append(line).append("\n");
    last = origin;
  }
  return text;
}

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

// The first declaration that cannot be a member.
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
    if (declaration.brace == code.npos && !first.empty() && first != "const" &&
        function_name(head.substr(0, head.size() - 1)).empty())
      return fail(declaration.begin,
                  "a variable outside of functions is not C++ here: make it const, or a parameter");
  }
  return std::nullopt;
}

// {0}: the name of the class, {1}: its members, {2}: a namespace in which GLM needs no prefix.
constexpr std::string_view kFrame = R"(// Made by gnomonc from shader modules: change those instead.
#ifndef GNOMON_CPP_{0}_H
#define GNOMON_CPP_{0}_H

#include <cstdio>
#include <exception>
#include <glm/glm.hpp>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

namespace gnomon {{
namespace {2} {{

using namespace glm;

struct {0} {{
  virtual ~{0}() = default;

{1}
}};

}}  // namespace {2}

using {2}::{0};

}}  // namespace gnomon

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#endif
)";

Result<Done> check_modules(const std::vector<std::string>& paths, const Options& options) {
  for (const std::string& path : paths) {
    const Result<Compiled> checked = check(path, options);
    if (!checked) return checked.diagnostics();
    if (!checked->is_module)
      return Diagnostic{.file = path, .message = "has a main(): it is a shader, not a module"};
  }
  return Done{};
}

// All of them in one text: two may define the same function.
std::optional<Diagnostic> check_together(const Assembled& assembled, const Options& options) {
  const Shader shader = compile(assembled.text, Stage::kFragment, *find_target(options.target));
  if (!shader.error) return std::nullopt;
  return locate(assembled, shader.error->line, shader.error->text);
}

}  // namespace

Result<CppHeader> cpp_header(const std::vector<std::string>& paths, const Options& options) {
  if (const auto checked = check_modules(paths, options); !checked) return checked.diagnostics();
  Result<Assembled> assembled = assemble_all(paths, options);
  if (!assembled) return assembled.diagnostics();
  if (auto clash = check_together(*assembled, options)) return *std::move(clash);
  if (auto foreign = find_foreign(*assembled)) return *std::move(foreign);
  std::string text = with_origins(*assembled, options.library_directory);
  Members(text).rewrite();
  const std::string name = options.name.empty() ? "Modules" : options.name;
  const std::string scope = options.name.empty() ? "modules" : options.name + "_modules";
  return CppHeader{fmt::format(fmt::runtime(kFrame), name, text, scope),
                   {assembled->files.begin() + 1, assembled->files.end()}};
}

}  // namespace gnomon::compiler
