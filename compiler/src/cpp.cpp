// SPDX-License-Identifier: MIT
#include "gnomon/compiler/cpp.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>
#include <utility>

#include "assemble.h"
#include "cpp_subset.h"
#include "declaration_text.h"
#include "origin.h"
#include "shader.h"
#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

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
  if (type.empty() && last == "void") return {};
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
  // `shader`: what is in force of the text.
  Members(std::string& text, const Shader& shader) : text_(text), code_(declarations_only(text)) {
    for (const Function& function : shader.defined)
      in_force_.emplace(function.name, function.parameters.size());
  }

  void rewrite() {
    const std::vector<Declaration> declarations = find_declarations(code_);
    for (const Declaration& declaration : declarations) {
      if (declaration.brace != code_.npos && is_in_force(head_of(declaration)))
        defined_.insert(signature_of(head_of(declaration)));
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

  // A definition may stand under a conditional that does not hold: then the prototype is all there is.
  [[nodiscard]] bool is_in_force(std::string_view head) const {
    const std::string signature = signature_of(head);
    const auto commas = static_cast<size_t>(std::ranges::count(signature, ','));
    return in_force_.contains({std::string(function_name(head)), signature.ends_with(',') ? 0 : commas});
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
  std::set<std::pair<std::string, size_t>> in_force_;  // name and number of parameters
  std::set<std::string> defined_;                      // or declared, by signature
  std::vector<std::pair<size_t, std::string>> insertions_;
};

std::string literal_path(const std::string& path) {
  std::string literal;
  for (const char c : path) literal += c == '"' || c == '\\' ? std::string{'\\', c} : std::string{c};
  return literal;
}

// A #line wherever the next line is not the one that follows the last in the same file.
std::string with_origins(const Assembled& assembled, const std::vector<std::string>& names) {
  std::string text;
  LineOrigin last{-1, 0};
  std::string_view rest = assembled.text;
  for (const LineOrigin& origin : assembled.origins) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    const std::string_view line = rest.substr(0, length);
    rest.remove_prefix(std::min(length + 1, rest.size()));
    if (line.starts_with("#version")) continue;
    if (origin.line > 0 && (origin.inclusion != last.inclusion || origin.line != last.line + 1)) {
      text += fmt::format(
          "#line {} \"{}\"\n", origin.line,
          literal_path(
              names[static_cast<size_t>(assembled.inclusions[static_cast<size_t>(origin.inclusion)].file)]));
    }
    text.append(line).append("\n");
    last = origin;
  }
  return text;
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

// Precisions mean nothing in C++.
void blank_precisions(std::string& text) {
  const std::string code = blank_comments(text);
  for (const Token& token : tokenize(code)) {
    if (!token.is("highp") && !token.is("mediump") && !token.is("lowp")) continue;
    const auto begin = text.begin() + (token.text.data() - code.data());
    std::fill_n(begin, token.text.size(), ' ');
  }
}

// What #line calls each file: those of the library gnomon/..., others by their names, with the folders that
// tell them apart where two are called alike.
std::vector<std::string> names_of(const Assembled& assembled, const std::string& library) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  std::vector<fs::path> paths;
  for (const std::string& file : assembled.files) {
    std::error_code ignored;
    names.push_back(portable_name(file, assembled, library));
    paths.push_back(fs::absolute(file, ignored).lexically_normal());
  }
  for (size_t i = 0; i < names.size(); ++i) {
    std::string name = names[i];
    fs::path folder = paths[i].parent_path();
    const auto is_taken = [&](size_t other) {
      const std::string path = paths[other].generic_string();
      return other != i && path != paths[i] && path.ends_with("/" + name);
    };
    bool taken = true;
    while (taken && folder.has_relative_path() && !name.starts_with("gnomon/")) {
      taken = false;
      for (size_t other = 0; other < names.size(); ++other) taken = taken || is_taken(other);
      if (taken) name.insert(0, folder.filename().generic_string() + "/");
      folder = folder.parent_path();
    }
    names[i] = name;
  }
  return names;
}

}  // namespace

Result<CppHeader> cpp_header(const std::vector<std::string>& paths, const Options& options) {
  if (const auto checked = check_modules(paths, options); !checked) return checked.diagnostics();
  Result<Assembled> assembled = assemble_all(paths, options);
  if (!assembled) return assembled.diagnostics();
  // All of them in one text: two may define the same function.
  const Shader shader = compile(assembled->text, Stage::kFragment, *find_target(options.target));
  if (shader.error) return locate(*assembled, shader.error->line, shader.error->text);
  if (auto foreign = find_foreign(*assembled)) return *std::move(foreign);
  std::string text = with_origins(*assembled, names_of(*assembled, options.library_directory));
  blank_precisions(text);
  Members(text, shader).rewrite();
  const std::string name = options.name.empty() ? "Modules" : options.name;
  const std::string scope = options.name.empty() ? "modules" : options.name + "_modules";
  return CppHeader{fmt::format(fmt::runtime(kFrame), name, text, scope),
                   {assembled->files.begin() + 1, assembled->files.end()}};
}

}  // namespace gnomon::compiler
