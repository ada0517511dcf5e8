// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gnomon/compiler/compiler.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

std::string what_is_wrong_with_name(std::string_view name) {
  if (!is_identifier(name)) return "is not an identifier (letters, digits and _, not starting with a digit)";
  if (name.starts_with("gl_") || name.starts_with("GL_"))
    return "starts with gl_, which GLSL reserves: choose another";
  if (name.find("__") != name.npos)
    return "contains a double underscore, which GLSL reserves: choose another";
  if (name == "defined") return "is reserved by the GLSL preprocessor: choose another";
  return {};
}

// The define becomes one line of the text: nothing in it may open a comment or swallow the next line.
std::string what_is_wrong_with_value(std::string_view value) {
  if (value.find_first_of(std::string_view("\n\r\0", 3)) != value.npos)
    return "has a line break: write it in one line";
  if (value.find("//") != value.npos || value.find("/*") != value.npos) return "has a comment: leave it out";
  if (value.ends_with('\\')) return "ends in a backslash: leave it out";
  return {};
}

}  // namespace

Result<Define> parse_define(std::string_view text) {
  const size_t equals = std::min(text.find('='), text.size());
  Define define{std::string(text.substr(0, equals)), "1"};
  if (equals < text.size()) define.value = text.substr(equals + 1);

  std::string defect = what_is_wrong_with_name(define.name);
  if (!defect.empty()) return Diagnostic{.message = "-D: the name \"" + define.name + "\" " + defect};
  defect = what_is_wrong_with_value(define.value);
  if (!defect.empty()) return Diagnostic{.message = "-D " + define.name + ": the value " + defect};
  return define;
}

}  // namespace gnomon::compiler
