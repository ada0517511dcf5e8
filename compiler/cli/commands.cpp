// SPDX-License-Identifier: MIT
#include "cli/commands.h"

#include <algorithm>
#include <cstdio>

#include "cli/dependencies.h"
#include "cli/modules_header.h"
#include "cli/output.h"
#include "gnomon/compiler/modules.h"

namespace gnomon::cli {
namespace {

int report(const Diagnostics& diagnostics, ErrorFormat error_format) {
  int code = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    std::fprintf(stderr, "%s\n", format(diagnostic, error_format).c_str());
    if (!diagnostic.warning) code = std::max(code, static_cast<int>(diagnostic.failure));
  }
  return code;
}

int report(const Result<Done>& done, const Command& command) {
  return done ? 0 : report(done.diagnostics(), command.error_format);
}

int build(const Command& command) {
  if (const auto shared = shared_output(command)) return report({*shared}, command.error_format);
  const auto shader = compiler::build(command.files.front(), command.options);
  if (!shader) {
    const int failed = report(shader.diagnostics(), command.error_format);
    if (failed != static_cast<int>(Failure::kFailed)) return failed;
    // A build system tries again when one of these files changes.
    return std::max(failed, report(write_depfile(command), command));
  }
  report(shader->source.warnings, command.error_format);
  return report(write(*shader, command), command);
}

int check(const Command& command) {
  int code = 0;
  for (const std::string& file : command.files) {
    const auto shader = compiler::check(file, command.options);
    code =
        std::max(code, report(shader ? shader->source.warnings : shader.diagnostics(), command.error_format));
  }
  return code;
}

int graph(const Command& command) {
  const auto text = graph_text(command);
  return report(text ? print(*text) : text.diagnostics(), command);
}

int list(const Command& command) {
  const auto modules = compiler::list_modules(command.options.library_directory);
  return report(modules ? print(compiler::to_table(*modules)) : modules.diagnostics(), command);
}

}  // namespace

int run(const Command& command) {
  switch (command.name) {
    case Command::Name::kBuild:
      return build(command);
    case Command::Name::kCheck:
      return check(command);
    case Command::Name::kCpp:
      return report(write_cpp(command), command);
    case Command::Name::kGraph:
      return graph(command);
    case Command::Name::kList:
      break;
  }
  return list(command);
}

}  // namespace gnomon::cli
