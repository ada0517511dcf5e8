// SPDX-License-Identifier: MIT
#include "gnomon/compiler/modules.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "text.h"

namespace gnomon::compiler {
namespace {

namespace fs = std::filesystem;

std::string* field_of(Module& module, std::string_view key) {
  if (key == "summary") return &module.summary;
  if (key == "source") return &module.source;
  if (key == "host") return &module.host;
  if (key == "options") return &module.options;
  return nullptr;
}

// The comment that the file begins with.
void read_header(std::istream& file, Module& module) {
  std::string* field = nullptr;
  for (std::string line; std::getline(file, line) && line.starts_with("//");) {
    const std::string_view text = std::string_view(line).substr(2);
    const size_t colon = std::min(text.find(':'), text.size());
    if (std::string* named = field_of(module, trim(text.substr(0, colon)))) {
      field = named;
      *field = trim(text.substr(colon + 1));
    } else if (field != nullptr && text.starts_with("  ")) {
      field->append(" ").append(trim(text));
    } else {
      field = nullptr;
    }
  }
}

Diagnostic unreadable(const std::string& path, std::string_view what) {
  return {.file = path, .message = "cannot read the " + std::string(what)};
}

std::vector<fs::path> find_files(const fs::path& library, std::error_code& error) {
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator entry(library, error), end; !error && entry != end;
       entry.increment(error)) {
    const fs::path name = entry->path().lexically_relative(library);
    std::error_code ignored;  // a link that leads nowhere, or round
    if (name == "programs") {
      entry.disable_recursion_pending();
    } else if (name.extension() == ".glsl" && entry->is_regular_file(ignored)) {
      files.push_back(name);
    }
  }
  return files;
}

}  // namespace

Result<Module> read_module(const std::string& path) {
  Module module{.name = {}, .path = path, .summary = {}, .source = {}, .host = {}, .options = {}};
  std::ifstream file(path);
  read_header(file, module);
  if (!file.is_open() || file.bad()) return unreadable(path, "module");
  return module;
}

Result<std::vector<Module>> list_modules(const std::string& library_directory) {
  std::error_code error;
  const auto names = find_files(library_directory, error);
  if (error) return unreadable(library_directory, "shader library: " + error.message());
  std::vector<Module> modules;
  for (const fs::path& name : names) {
    Result<Module> module = read_module((fs::path(library_directory) / name).string());
    if (!module) return module.diagnostics();
    module->name = fs::path(name).replace_extension().generic_string();
    modules.push_back(std::move(module).value());
  }
  std::ranges::sort(modules, {}, &Module::name);
  return modules;
}

std::string to_table(const std::vector<Module>& modules) {
  size_t name_width = 0;
  size_t summary_width = 0;
  for (const Module& module : modules) {
    name_width = std::max(name_width, module.name.size());
    summary_width = std::max(summary_width, module.summary.size());
  }
  std::string table;
  for (const Module& module : modules) {
    table += fmt::format("{:{}}  {:{}}  {}\n", module.name, name_width, module.summary, summary_width,
                         module.source);
  }
  return table;
}

}  // namespace gnomon::compiler
