// SPDX-License-Identifier: MIT
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <iostream>
#include <string>

#include "cli/arguments.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "gnomon/library_location.h"

namespace {

std::atomic<bool> interrupted = false;

void interrupt(int) {
  interrupted = true;
}

/// A second interrupt ends the program at once.
void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = SA_RESETHAND;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int terminal_columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gnomon;
  const cli::CommandLine line = cli::parse_arguments(argc, argv);
  if (!line.command) {
    (line.exit_code == 0 ? std::cout : std::cerr) << line.text;
    return line.exit_code;
  }
  std::error_code error;
  const std::string executable = std::filesystem::read_symlink("/proc/self/exe", error).string();
  const auto* test = std::get_if<cli::TestArguments>(&*line.command);
  if (!test || !test->worker) catch_interrupts();
  cli::Console console{.out = std::cout,
                       .err = std::cerr,
                       .terminal = isatty(STDERR_FILENO) == 1,
                       .columns = terminal_columns(),
                       .program = argv[0],
                       .executable = executable,
                       .shader_library = shader_library(executable),
                       .interrupted = interrupted};
  const int code =
      std::visit([&](const auto& arguments) { return cli::run_command(arguments, console); }, *line.command);
  if (!std::cout.flush()) {
    std::cerr << "error: cannot write to standard output\n";
    return cli::worse(code, static_cast<int>(Failure::kMachine));
  }
  return code;
}
