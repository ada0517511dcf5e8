// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdio>

#include "cli/command_line.h"
#include "cli/dependencies.h"
#include "cli/output.h"
#include "gnomon/compiler/modules.h"
#include "gnomon/library_location.h"

namespace {

using namespace gnomon;

int report(const Diagnostics& diagnostics, cli::ErrorFormat format) {
  int code = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    std::fprintf(stderr, "%s\n", cli::format(diagnostic, format).c_str());
    if (!diagnostic.warning) code = std::max(code, static_cast<int>(diagnostic.failure));
  }
  return code;
}

int build(const cli::Command& command) {
  const auto shader = compiler::build(command.files.front(), command.options);
  const int failed = shader ? 0 : report(shader.diagnostics(), command.error_format);
  if (failed == static_cast<int>(Failure::kInvalid)) return failed;
  const auto noted = cli::write_depfile(command);
  if (!noted) return report(noted.diagnostics(), command.error_format);
  if (!shader) return failed;
  report(shader->warnings, command.error_format);
  const auto written = cli::write(*shader, command.output);
  return written ? 0 : report(written.diagnostics(), command.error_format);
}

int check(const cli::Command& command) {
  int code = 0;
  for (const std::string& file : command.files) {
    const auto shader = compiler::check(file, command.options);
    code = std::max(code, report(shader ? shader->warnings : shader.diagnostics(), command.error_format));
  }
  return code;
}

int graph(const cli::Command& command) {
  const auto text = cli::graph_text(command);
  const Result<Done> printed = text ? cli::print(*text) : text.diagnostics();
  return printed ? 0 : report(printed.diagnostics(), command.error_format);
}

int list(const cli::Command& command) {
  const auto modules = compiler::list_modules(command.options.library_directory);
  const Result<Done> printed = modules ? cli::print(compiler::to_table(*modules)) : modules.diagnostics();
  return printed ? 0 : report(printed.diagnostics(), command.error_format);
}

}  // namespace

int main(int argc, char** argv) {
  const cli::CommandLine line = cli::parse_command_line(argc, argv, shader_library("/proc/self/exe"));
  if (!line.command) {
    std::fputs(line.text.c_str(), line.exit_code == 0 ? stdout : stderr);
    return line.exit_code;
  }
  switch (line.command->name) {
    case cli::Command::Name::kBuild:
      return build(*line.command);
    case cli::Command::Name::kCheck:
      return check(*line.command);
    case cli::Command::Name::kGraph:
      return graph(*line.command);
    case cli::Command::Name::kList:
      break;
  }
  return list(*line.command);
}
