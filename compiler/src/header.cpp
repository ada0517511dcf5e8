// SPDX-License-Identifier: MIT
#include "header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>

#include "text.h"

namespace gnomon::compiler {
namespace {

// Names that GLSL lets a variable have and that mean something else in C++ or in the header itself.
constexpr std::array<std::string_view, 59> kTaken = {
    "NULL",         "Member",     "Variable",      "alignas",     "alignof",
    "all",          "and",        "and_eq",        "auto",        "bitand",
    "bitor",        "catch",      "char",          "char16_t",    "char32_t",
    "char8_t",      "co_await",   "co_return",     "co_yield",    "compl",
    "concept",      "const_cast", "consteval",     "constexpr",   "constinit",
    "decltype",     "delete",     "dynamic_cast",  "explicit",    "export",
    "friend",       "linux",      "mutable",       "new",         "noexcept",
    "not",          "not_eq",     "nullptr",       "operator",    "or",
    "or_eq",        "private",    "protected",     "register",    "reinterpret_cast",
    "requires",     "signed",     "static_assert", "static_cast", "std",
    "thread_local", "throw",      "try",           "typeid",      "typename",
    "unix",         "virtual",    "wchar_t",       "xor"};

// A C++ identifier for a GLSL name ("light.position", "lights[1]"), other than those given before.
class Names {
 public:
  std::string operator()(std::string_view name) {
    std::string identifier;
    for (const char c : name) identifier += is_word_character(c) ? c : '_';
    if (identifier.empty() || (identifier[0] >= '0' && identifier[0] <= '9')) identifier.insert(0, 1, '_');
    if (std::ranges::find(kTaken, identifier) != kTaken.end()) identifier += '_';
    while (!given_.insert(identifier).second) identifier += '_';
    return identifier;
  }

 private:
  std::set<std::string> given_;
};

std::string literal_of(std::string_view text) {
  std::string literal = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || c == '?') {  // ?: trigraphs
      literal.append(1, '\\').append(1, c);
    } else if (byte < 0x20 || byte >= 0x7f) {
      literal += fmt::format("\\{:03o}", byte);
    } else {
      literal += c;
    }
  }
  return literal + "\"";
}

// One literal a line. Visual C++ takes 65,535 bytes in one constant, so longer texts are spelt in numbers.
std::string text_constant(std::string_view text) {
  constexpr size_t kLongestLiteral = 65000;
  std::string code;
  if (text.size() > kLongestLiteral) {
    code = fmt::format("inline constexpr char source_bytes[] = {{");
    for (size_t i = 0; i < text.size(); ++i)
      code += fmt::format("{}'\\{:03o}',", i % 16 == 0 ? "\n    " : "", static_cast<unsigned char>(text[i]));
    return code +
           fmt::format("\n}};\ninline constexpr std::string_view source(source_bytes, {});\n", text.size());
  }
  code = "inline constexpr std::string_view source =\n    \"\"";
  while (!text.empty()) {
    const size_t length = std::min(text.find('\n'), text.size() - 1) + 1;
    const bool ends = text[length - 1] == '\n';
    std::string literal = literal_of(text.substr(0, ends ? length - 1 : length));
    if (ends) literal.insert(literal.size() - 1, "\\n");
    code += "\n    " + literal;
    text.remove_prefix(length);
  }
  return code + ";\n";
}

std::string words_constant(std::string_view bytes) {
  const size_t count = bytes.size() / sizeof(std::uint32_t);
  std::string code = fmt::format("inline constexpr std::array<std::uint32_t, {}> spirv = {{", count);
  for (size_t i = 0; i < count; ++i) {
    std::uint32_t word = 0;
    std::memcpy(&word, bytes.data() + i * sizeof word, sizeof word);
    code += fmt::format("{}0x{:08x},", i % 8 == 0 ? "\n    " : " ", word);
  }
  return code + "\n};\n";
}

int or_none(const std::optional<int>& number) {
  return number.value_or(-1);
}

std::string of_variable(const std::string& identifier, const Variable& v) {
  return fmt::format("inline constexpr Variable {}{{{}, {}, {}, {}, {}, {}}};\n", identifier,
                     literal_of(v.name), literal_of(v.type), v.array_size, or_none(v.location),
                     or_none(v.set), or_none(v.binding));
}

// A namespace with a constant for each variable and `all` of them.
std::string list_of_variables(std::string_view name, const std::vector<Variable>& variables) {
  Names names;
  std::string code = fmt::format("namespace {} {{\n", name);
  std::string all;
  for (const Variable& variable : variables) {
    const std::string identifier = names(variable.name);
    code += of_variable(identifier, variable);
    all += (all.empty() ? "" : ", ") + identifier;
  }
  code += fmt::format("inline constexpr std::array<Variable, {}> all = {{{}}};\n", variables.size(), all);
  return code + fmt::format("}}  // namespace {}\n", name);
}

std::string of_member(const std::string& identifier, const Member& m) {
  return fmt::format("inline constexpr Member {}{{{}, {}, {}, {}, {}, {}, {}}};\n", identifier,
                     literal_of(m.name), literal_of(m.type), or_none(m.offset), m.array_size,
                     or_none(m.array_stride), or_none(m.matrix_stride), m.is_row_major);
}

std::string of_block(const std::string& identifier, const Block& block) {
  Names names;
  std::string code = fmt::format("namespace {} {{\n", identifier);
  const auto add_number = [&](const char* name, int number) {
    code += fmt::format("inline constexpr int {} = {};\n", names(name), number);
  };
  code += fmt::format("inline constexpr std::string_view {} = {};\n", names("name"), literal_of(block.name));
  add_number("array_size", block.array_size);
  add_number("size", or_none(block.size));
  add_number("set", or_none(block.set));
  add_number("binding", or_none(block.binding));
  for (const Member& member : block.members) code += of_member(names(member.name), member);
  return code + fmt::format("}}  // namespace {}\n", identifier);
}

std::string of_target(const Compiled& compiled) {
  const Reflection& reflection = compiled.reflection;
  std::string code = fmt::format("\nnamespace {} {{\n", reflection.target);
  code += find_target(reflection.target)->format == Format::kSpirv ? words_constant(compiled.output)
                                                                   : text_constant(compiled.output);
  code += list_of_variables("inputs", reflection.inputs);
  code += list_of_variables("outputs", reflection.outputs);
  code += list_of_variables("uniforms", reflection.uniforms);
  code += list_of_variables("textures", reflection.textures);
  code += "namespace blocks {\n";
  Names names;
  for (const Block& block : reflection.blocks) code += of_block(names(block.name), block);
  code += "}  // namespace blocks\n";
  if (!reflection.constants.empty()) {
    Names constants;
    code += "namespace constants {  // identifiers of specialization constants\n";
    for (const SpecializationConstant& constant : reflection.constants)
      code += fmt::format("inline constexpr int {} = {};\n", constants(constant.name), constant.id);
    code += "}  // namespace constants\n";
  }
  if (reflection.local_size.size() == 3) {
    code += fmt::format("inline constexpr std::array<int, 3> local_size = {{{}, {}, {}}};\n",
                        reflection.local_size[0], reflection.local_size[1], reflection.local_size[2]);
  }
  return code + fmt::format("}}  // namespace {}\n", reflection.target);
}

constexpr std::string_view kTypes = R"(
// -1: there is none; without a location or binding the host binds by name. array_size 0: no array.
struct Variable {
  std::string_view name;
  std::string_view type;
  int array_size;
  int location;
  int set;
  int binding;
};
// Offset and strides in bytes.
struct Member {
  std::string_view name;
  std::string_view type;
  int offset;
  int array_size;
  int array_stride;
  int matrix_stride;
  bool is_row_major;
};
)";

}  // namespace

std::string header_text(const std::string& file, const std::string& wanted_name,
                        const std::vector<Compiled>& embedded) {
  Names names;
  const std::string name = names(wanted_name.empty() ? file : wanted_name);
  const std::string guard = "GNOMON_SHADERS_" + name + "_H";
  std::string code = fmt::format(
      "// Made by gnomonc from {}: change that file instead.\n#ifndef {}\n#define {}\n\n#include <array>\n"
      "#include <cstdint>\n#include <string_view>\n\nnamespace gnomon_shaders::{} {{\n",
      file, guard, guard, name);
  code += fmt::format("\ninline constexpr std::string_view stage = {};\n",
                      literal_of(stage_name(embedded.front().reflection.stage).title));
  code += kTypes;
  for (const Compiled& compiled : embedded) code += of_target(compiled);
  return code + fmt::format("\n}}  // namespace gnomon_shaders::{}\n\n#endif\n", name);
}

}  // namespace gnomon::compiler
