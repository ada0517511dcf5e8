// SPDX-License-Identifier: MIT
#include "header.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <set>
#include <string_view>

#include "text.h"

namespace gnomon::compiler {
namespace {

// Names that GLSL lets a variable have and that mean something else in C++, in the header itself, or as
// macros of the systems' headers.
constexpr auto kTaken = std::to_array<std::string_view>(
    {"BUFSIZ",       "DOMAIN",     "EOF",          "FALSE",     "FLT_MAX",
     "FLT_MIN",      "HUGE_VAL",   "HUGE_VALF",    "I",         "INFINITY",
     "INT32_MAX",    "INT_MAX",    "INT_MIN",      "M_PI",      "Member",
     "HostFunction", "Option",     "NAN",          "NDEBUG",    "NULL",
     "OVERFLOW",     "RAND_MAX",   "TRUE",         "UINT_MAX",  "UNDERFLOW",
     "Variable",     "alignas",    "alignof",      "all",       "and",
     "and_eq",       "assert",     "auto",         "bitand",    "bitor",
     "catch",        "char",       "char16_t",     "char32_t",  "char8_t",
     "co_await",     "co_return",  "co_yield",     "compl",     "complex",
     "concept",      "const_cast", "consteval",    "constexpr", "constinit",
     "decltype",     "delete",     "dynamic_cast", "errno",     "explicit",
     "export",       "far",        "friend",       "interface", "linux",
     "major",        "makedev",    "max",          "min",       "minor",
     "mutable",      "near",       "new",          "noexcept",  "not",
     "not_eq",       "nullptr",    "offsetof",     "operator",  "or",
     "or_eq",        "private",    "protected",    "register",  "reinterpret_cast",
     "requires",     "signbit",    "signed",       "small",     "static_assert",
     "static_cast",  "std",        "stderr",       "stdin",     "stdout",
     "thread_local", "throw",      "try",          "typeid",    "typename",
     "unix",         "virtual",    "wchar_t",      "xor"});

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
    code = fmt::format("constexpr char source_bytes[] = {{");
    for (size_t i = 0; i < text.size(); ++i)
      code += fmt::format("{}'\\{:03o}',", i % 16 == 0 ? "\n    " : "", static_cast<unsigned char>(text[i]));
    // Ends in a zero outside of the view, as a literal does.
    return code +
           fmt::format("\n    '\\0'}};\nconstexpr std::string_view source(source_bytes, {});\n", text.size());
  }
  code = "constexpr std::string_view source =\n    \"\"";
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
  std::string code = fmt::format("constexpr std::array<std::uint32_t, {}> spirv = {{", count);
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
  return fmt::format("constexpr Variable {}{{{}, {}, {}, {}, {}, {}, {}}};\n", identifier, literal_of(v.name),
                     literal_of(v.type), v.array_size, or_none(v.location), or_none(v.set),
                     or_none(v.binding), or_none(v.input_attachment_index));
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
  code += fmt::format("constexpr std::array<Variable, {}> all = {{{}}};\n", variables.size(), all);
  return code + fmt::format("}}  // namespace {}\n", name);
}

std::string of_member(const std::string& identifier, const Member& m) {
  return fmt::format("constexpr Member {}{{{}, {}, {}, {}, {}, {}, {}}};\n", identifier, literal_of(m.name),
                     literal_of(m.type), or_none(m.offset), m.array_size, or_none(m.array_stride),
                     or_none(m.matrix_stride), m.is_row_major);
}

std::string of_block(const std::string& identifier, const Block& block) {
  Names names;
  std::string code = fmt::format("namespace {} {{\n", identifier);
  const auto add_number = [&](const char* name, int number) {
    code += fmt::format("constexpr int {} = {};\n", names(name), number);
  };
  code += fmt::format("constexpr std::string_view {} = {};\n", names("name"), literal_of(block.name));
  code +=
      fmt::format("constexpr std::string_view {} = {};\n", names("kind"), literal_of(kind_name(block.kind)));
  code += fmt::format("constexpr bool {} = {};\n", names("is_readonly"), block.is_readonly);
  add_number("array_size", block.array_size);
  add_number("size", or_none(block.size));
  add_number("set", or_none(block.set));
  add_number("binding", or_none(block.binding));
  for (const Member& member : block.members) code += of_member(names(member.name), member);
  return code + fmt::format("}}  // namespace {}\n", identifier);
}

std::string list_of_host_functions(const std::vector<HostFunction>& functions) {
  std::string all;
  for (const HostFunction& f : functions)
    all += fmt::format("{}{{{}, {}}}", all.empty() ? "" : ", ", literal_of(f.name), literal_of(f.file));
  return fmt::format("constexpr std::array<HostFunction, {}> host_functions = {{{{{}}}}};\n",
                     functions.size(), all);
}

std::string list_of_options(const std::vector<OptionValue>& options) {
  std::string all;
  for (const OptionValue& o : options)
    all += fmt::format("{}{{{}, {}, {}}}", all.empty() ? "" : ", ", literal_of(o.name), literal_of(o.value),
                       literal_of(o.default_value));
  return fmt::format("constexpr std::array<Option, {}> options = {{{{{}}}}};\n", options.size(), all);
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
      code += fmt::format("constexpr int {} = {};\n", constants(constant.name), constant.id);
    code += "}  // namespace constants\n";
  }
  code += list_of_host_functions(reflection.host_functions);
  code += list_of_options(reflection.options);
  if (reflection.spirv_size)
    code += fmt::format("constexpr std::size_t spirv_size = {};\n", *reflection.spirv_size);
  if (reflection.local_size.size() == 3) {
    code += fmt::format("constexpr std::array<int, 3> local_size = {{{}, {}, {}}};\n",
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
  int input_attachment_index;
};
// A function of the host contract that the shader calls, and where it is defined.
struct HostFunction {
  std::string_view name;
  std::string_view file;
};
// A macro that a module names as an option: its value in this shader, and without a definition.
struct Option {
  std::string_view name;
  std::string_view value;
  std::string_view default_value;
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
  std::string body = fmt::format("constexpr std::string_view stage = {};\n",
                                 literal_of(stage_name(embedded.front().reflection.stage).title));
  body += kTypes;
  for (const Compiled& compiled : embedded) body += of_target(compiled);
  // {0} file, {1} guard, {2} what tells this header from another one of the same name, {3} name, {4} body
  return fmt::format(R"(// Made by gnomonc from {0}: change that file instead.
#if defined({1}) && {1} != {2}
#error "two shaders are called {3}: give one of them another name with gnomonc build --name"
#endif
#ifndef {1}
#define {1} {2}

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

// Of internal linkage: two shaders of one name in two files of a program are not taken for each other.
namespace gnomon_shaders::{3} {{

{4}
}}  // namespace gnomon_shaders::{3}

#endif
)",
                     file, "GNOMON_SHADERS_" + name + "_H",
                     fmt::format("0x{:08x}", XXH32(body.data(), body.size(), 0)), name, body);
}

}  // namespace gnomon::compiler
