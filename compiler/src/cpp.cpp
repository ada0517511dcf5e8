// SPDX-License-Identifier: MIT
#include "gnomon/compiler/cpp.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "assemble.h"
#include "origin.h"
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

// What makes a member of a declaration: texts to insert and places to blank.
class Members {
 public:
  explicit Members(std::string& text) : text_(text), code_(declarations_only(text)) {}

  void rewrite() {
    const std::vector<Declaration> declarations = find_declarations(code_);
    for (const Declaration& declaration : declarations) {
      if (declaration.brace != code_.npos) defined_.insert(function_name(head_of(declaration)));
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
    const std::string_view name = function_name(head);
    if (name.empty()) {
      if (trim(head).starts_with("const ")) insertions_.emplace_back(declaration.begin, "static inline ");
    } else if (declaration.brace != code_.npos) {
      insertions_.emplace_back(declaration.brace, "const ");
    } else if (defined_.contains(name)) {  // a class takes no second declaration of a member
      for (size_t i = declaration.begin; i < declaration.end; ++i) {
        if (text_[i] != '\n') text_[i] = ' ';
      }
    } else {
      insertions_.emplace_back(declaration.begin, "virtual ");
      insertions_.emplace_back(declaration.end - 1, " const = 0");
    }
  }

  std::string& text_;
  const std::string code_;
  std::set<std::string_view> defined_;
  std::vector<std::pair<size_t, std::string>> insertions_;
};

// A #line wherever the next line is not the one that follows the last in the same file.
std::string with_origins(const Assembled& assembled, const std::string& library) {
  std::string text;
  LineOrigin last{-1, 0};
  std::string_view rest = assembled.text;
  for (const LineOrigin& origin : assembled.origins) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    if (origin.line > 0 && !rest.starts_with("#version")) {
      if (origin.inclusion != last.inclusion || origin.line != last.line + 1) {
        text += fmt::format("#line {} \"{}\"\n", origin.line,
                            portable_name(file_of(assembled, origin.inclusion), assembled, library));
      }
      text.append(rest.substr(0, length)).append("\n");
      last = origin;
    }
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return text;
}

constexpr std::string_view kBegin = R"(// Made by gnomonc from shader modules: change those instead.
#ifndef GNOMON_MODULES_H
#define GNOMON_MODULES_H

#include <glm/glm.hpp>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

namespace gnomon {
namespace modules {

using namespace glm;

struct Modules {
  virtual ~Modules() = default;

)";

constexpr std::string_view kEnd = R"(
};

}  // namespace modules

using modules::Modules;

}  // namespace gnomon

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

}  // namespace

Result<std::string> cpp_header(const std::vector<std::string>& paths, const Options& options) {
  if (const auto checked = check_modules(paths, options); !checked) return checked.diagnostics();
  Result<Assembled> assembled = assemble_all(paths, options);
  if (!assembled) return assembled.diagnostics();
  std::string text = with_origins(*assembled, options.library_directory);
  Members(text).rewrite();
  return std::string(kBegin) + text + std::string(kEnd);
}

}  // namespace gnomon::compiler
