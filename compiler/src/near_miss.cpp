// SPDX-License-Identifier: MIT
#include "near_miss.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "prototype.h"
#include "similar.h"

namespace gnomon::compiler {
namespace {

std::string spell(const Parameter& parameter) {
  switch (parameter.passing) {
    case Passing::kOut:
      return "out " + parameter.type.name;
    case Passing::kInOut:
      return "inout " + parameter.type.name;
    default:
      return parameter.type.name;
  }
}

// "float gnomon_host_height(ivec2, int)"
std::string spell(const Function& function) {
  std::string parameters;
  for (const Parameter& parameter : function.parameters)
    parameters += (parameters.empty() ? "" : ", ") + spell(parameter);
  return fmt::format("{} {}({})", function.result.name, function.name, parameters);
}

// The definition that was meant: of the same name with other parameters, or of nearly the same name.
const Function* find_near_miss(const Function& wanted, const std::vector<Function>& defined) {
  const auto overload = std::ranges::find(defined, wanted.name, &Function::name);
  if (overload != defined.end()) return &*overload;
  std::vector<std::string_view> names;
  for (const Function& function : defined) names.push_back(function.name);
  const std::string similar = similar_word(wanted.name, names);
  const auto found = std::ranges::find(defined, similar, &Function::name);
  return found == defined.end() ? nullptr : &*found;
}

}  // namespace

Message undefined_function(const std::string& name, const std::string& text, const Shader& shader) {
  const auto wanted = std::ranges::find(shader.undefined, name, &Function::name);
  if (wanted != shader.undefined.end()) {
    if (const Function* miss = find_near_miss(*wanted, shader.defined))
      return {
          miss->line,
          fmt::format("'{}' is defined here, but '{}' is what is declared and called: correct the definition",
                      spell(*miss), spell(*wanted)),
          line_of_prototype(text, name)};
  }
  const int prototype = line_of_prototype(text, name);
  const int call = wanted == shader.undefined.end() ? 0 : wanted->line;
  const bool is_host_function = name.starts_with("gnomon_host_");
  return {
      prototype > 0 ? prototype : call,
      fmt::format("function '{}' is declared and called, but not defined: {}", name,
                  is_host_function ? "define it, or include a ready-made host such as <gnomon/host/r32f.glsl>"
                                   : "define it, or include the file that does")};
}

}  // namespace gnomon::compiler
