// SPDX-License-Identifier: MIT
#include <sys/ioctl.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <exception>
#include <ext/stdio_filebuf.h>
#include <filesystem>
#include <iostream>
#include <optional>
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

/// A second interrupt ends the program at once. Who was started with one ignored (nohup, a script's trap) is
/// to stay so.
void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = interrupt;
  action.sa_flags = SA_RESETHAND;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction before {};
    sigaction(signal, &action, &before);
    if (before.sa_handler == SIG_IGN) sigaction(signal, &before, nullptr);
  }
}

int terminal_columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

/// A worker answers on what was its standard output; what any library prints there goes to standard error, so
/// that it cannot be taken for an answer.
class AnswerStream {
 public:
  AnswerStream() : buffer_(dup(STDOUT_FILENO), std::ios::out), stream_(&buffer_) {
    dup2(STDERR_FILENO, STDOUT_FILENO);
  }
  std::ostream& stream() { return stream_; }

 private:
  __gnu_cxx::stdio_filebuf<char> buffer_;
  std::ostream stream_;
};

int run(const gnomon::cli::Command& command, gnomon::cli::Console& console) {
  try {
    return std::visit([&](const auto& arguments) { return gnomon::cli::run_command(arguments, console); },
                      command);
  } catch (const std::exception& exception) {
    console.err << "error: out of resources: " << exception.what() << "\n";
    return static_cast<int>(gnomon::Failure::kMachine);
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gnomon;
  std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit fails instead, and is told
  const cli::CommandLine line = cli::parse_arguments(argc, argv);
  if (!line.command) {
    (line.exit_code == 0 ? std::cout : std::cerr) << line.text;
    return line.exit_code;
  }
  std::error_code error;
  const std::string executable = std::filesystem::read_symlink("/proc/self/exe", error).string();
  const auto* test = std::get_if<cli::TestArguments>(&*line.command);
  std::optional<AnswerStream> answers;
  if (test && test->worker) {
    answers.emplace();
  } else if (test || std::get_if<cli::RenderArguments>(&*line.command) ||
             std::get_if<cli::BenchArguments>(&*line.command)) {
    catch_interrupts();  // the others write at their end or nothing, and stop at once
  }
  cli::Console console{.in = std::cin,
                       .out = answers ? answers->stream() : std::cout,
                       .err = std::cerr,
                       .terminal = isatty(STDERR_FILENO) == 1,
                       .columns = terminal_columns(),
                       .program = argv[0],
                       .executable = executable,
                       .shader_library = shader_library(executable),
                       .interrupted = interrupted};
  const int code = run(*line.command, console);
  if (console.out.flush()) return code;
  std::cerr << "error: cannot write to standard output\n";
  return cli::worse(code, static_cast<int>(Failure::kMachine));
}
