// SPDX-License-Identifier: MIT
#include "cli/modules_header.h"

#include <span>

#include "cli/output.h"
#include "gnomon/atomic_file.h"
#include "gnomon/compiler/cpp.h"
#include "gnomon/compiler/modules.h"

namespace gnomon::cli {
namespace {

// A host reads textures, which C++ has none of.
Result<std::vector<std::string>> library_files(const std::string& library) {
  const auto modules = compiler::list_modules(library);
  if (!modules) return modules.diagnostics();
  std::vector<std::string> files;
  for (const compiler::Module& module : *modules) {
    if (!module.defines_host()) files.push_back(module.path);
  }
  return files;
}

}  // namespace

Result<Done> write_cpp(const Command& command) {
  const Result<std::vector<std::string>> files =
      command.files.empty() ? library_files(command.options.library_directory) : command.files;
  if (!files) return files.diagnostics();
  const Result<compiler::CppHeader> header = compiler::cpp_header(*files, command.options);
  if (!header) return header.diagnostics();
  if (command.output.empty()) return print(header->text);
  if (auto replaced = replaced_source(header->files, {command.output})) return *std::move(replaced);
  return write_file_atomically(command.output, std::as_bytes(std::span(header->text)));
}

}  // namespace gnomon::cli
