// SPDX-License-Identifier: MIT
#include <cstdio>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "gnomon/library_location.h"

int main(int argc, char** argv) {
  using namespace gnomon;
  const cli::CommandLine line = cli::parse_command_line(argc, argv, shader_library("/proc/self/exe"));
  if (line.command) return cli::run(*line.command);
  std::fputs(line.text.c_str(), line.exit_code == 0 ? stdout : stderr);
  return line.exit_code;
}
