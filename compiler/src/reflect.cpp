// SPDX-License-Identifier: MIT
#include "reflect.h"

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
    const bool is_called = std::ranges::find(shader.called, function.name) != shader.called.end();
    if (!function.name.starts_with("gnomon_host_") || !is_called) continue;
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
    const size_t close = entry.find(')');
    if (name.empty() || !entry.starts_with('(') || close == entry.npos) continue;
    const std::string stated(entry.substr(1, close - 1));
    options.push_back({std::string(name), stated, stated});
  }
  return options;
}

// What the first #define of a macro gives it: a -D, a line of the program, else the module's own.
void take_definitions(std::string_view text, std::vector<OptionValue>& options) {
  std::vector<std::string_view> seen;
  while (!text.empty()) {
    std::string_view line = trim(text.substr(0, text.find('\n')));
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
    if (!line.starts_with('#')) continue;
    line = trim(line.substr(1));
    if (take_word(line) != "define") continue;
    const std::string_view name = take_word(line);
    const auto option = std::ranges::find(options, name, &OptionValue::name);
    if (option == options.end() || std::ranges::find(seen, name) != seen.end()) continue;
    option->value = trim(line);
    seen.push_back(name);
  }
}

std::vector<OptionValue> options_of(const Assembled& source) {
  std::vector<OptionValue> options;
  for (const std::string& file : source.files) {
    const auto module = read_module(file);
    if (!module) continue;  // it was read a moment ago; without its header it has no options to tell
    std::ranges::copy(stated_options(module->options), std::back_inserter(options));
  }
  std::ranges::sort(options, {}, &OptionValue::name);
  const auto repeated = std::ranges::unique(options, {}, &OptionValue::name);
  options.erase(repeated.begin(), repeated.end());
  take_definitions(blank_comments(source.text), options);
  return options;
}

}  // namespace

Reflection complete_reflection(const Shader& shader, const Assembled& source, const std::string& library) {
  Reflection reflection = shader.interface;
  reflection.host_functions = host_functions(shader, source, library);
  reflection.options = options_of(source);
  return reflection;
}

}  // namespace gnomon::compiler
