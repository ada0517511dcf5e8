// SPDX-License-Identifier: MIT
#include "cli/dependencies.h"

#include <span>
#include <utility>
#include <vector>

#include "cli/output.h"
#include "gnomon/atomic_file.h"
#include "gnomon/compiler/depfile.h"
#include "gnomon/compiler/graph.h"

namespace gnomon::cli {

Result<Done> write_depfile(const Command& command) {
  if (command.depfile.empty()) return Done{};
  const std::vector<std::string> files = compiler::files_read(command.files.front(), command.options);
  if (auto replaced = replaced_source(files, {command.depfile, command.output})) return *std::move(replaced);
  const std::string rule = compiler::to_depfile(command.output, files);
  return write_file_atomically(path_of(command.depfile), std::as_bytes(std::span(rule)));
}

Result<std::string> graph_text(const Command& command) {
  const auto assembled = compiler::assemble(command.files.front(), command.options);
  if (!assembled) return assembled.diagnostics();
  return command.dot ? compiler::to_dot(*assembled) : compiler::to_tree(*assembled);
}

}  // namespace gnomon::cli
