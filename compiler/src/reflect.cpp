// SPDX-License-Identifier: MIT
#include "reflect.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "gnomon/compiler/modules.h"
#include "origin.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

std::vector<HostFunction> host_functions(const Shader& shader, const Assembled& source,
                                         const std::string& library) {
  std::vector<HostFunction> functions;
  for (const Function& function : shader.defined) {
    const bool is_reached = std::ranges::find(shader.reached, function.signature) != shader.reached.end();
    if (!function.name.starts_with("gnomon_host_") || !is_reached) continue;
    const std::string file = locate(source, function.line, {}).file;
    functions.push_back({function.name, portable_name(file, source, library)});
  }
  std::ranges::sort(functions, {}, &HostFunction::name);
  return functions;
}

// "NAME (default): text; NAME (default): text" of a module's header.
std::vector<OptionValue> stated_options(std::string_view text) {
  std::vector<OptionValue> options;
  while (!text.empty()) {
    std::string_view entry = trim(text.substr(0, text.find(';')));
    text.remove_prefix(std::min(text.find(';'), text.size() - 1) + 1);
    const std::string_view name = take_word(entry);
    // "(default):", with parentheses in the default.
    const size_t close = entry.find("):") == entry.npos ? entry.rfind(')') : entry.find("):");
    if (name.empty() || !entry.starts_with('(') || close == entry.npos) continue;
    const std::string stated(entry.substr(1, close - 1));
    options.push_back({std::string(name), stated, stated});
  }
  return options;
}

// What each macro stands for at the end of the text, asked of the preprocessor; one that is not defined keeps
// the value that the module states.
void take_values(const Assembled& source, Stage stage, const Target& target,
                 std::vector<OptionValue>& options) {
  constexpr std::string_view marker = "gnomon_option_value";
  if (options.empty()) return;
  std::string text = source.text;
  for (const OptionValue& option : options) text += fmt::format("{} {}\n", marker, option.name);
  const std::string preprocessed = preprocess(text, stage, target);
  std::string_view rest = preprocessed;
  for (OptionValue& option : options) {
    const size_t at = rest.find(marker);
    if (at == rest.npos) return;
    rest.remove_prefix(at + marker.size());
    const std::string_view value = trim(rest.substr(0, rest.find('\n')));
    if (value != option.name) option.value = value;
  }
}

std::vector<OptionValue> options_of(const Assembled& source, Stage stage, const Target& target) {
  std::vector<OptionValue> options;
  for (const std::string& file : source.files) {
    const auto module = read_module(file);
    if (!module) continue;  // it was read a moment ago; without its header it has no options to tell
    std::ranges::copy(stated_options(module->options), std::back_inserter(options));
  }
  std::ranges::sort(options, {}, &OptionValue::name);
  const auto repeated = std::ranges::unique(options, {}, &OptionValue::name);
  options.erase(repeated.begin(), repeated.end());
  take_values(source, stage, target, options);
  return options;
}

}  // namespace

Reflection complete_reflection(const Shader& shader, const Assembled& source, Stage stage,
                               const Target& target, const std::string& library) {
  Reflection reflection = shader.interface;
  if (target.format != Format::kSpirv) {  // HLSL and MSL have the bindings alone
    for (Variable& texture : reflection.textures) texture.set.reset();
    for (Block& block : reflection.blocks) block.set.reset();
  }
  reflection.host_functions = host_functions(shader, source, library);
  reflection.options = options_of(source, stage, target);
  return reflection;
}

}  // namespace gnomon::compiler
