// SPDX-License-Identifier: MIT
#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>

#include "cli/command_line.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "gnomon/library_location.h"

namespace {

// Outputs are whole or untouched at any time: an interrupt waits while they are written.
void stop(int) {
  constexpr std::string_view text = "gnomonc: interrupted; nothing more is written\n";
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
  ::_exit(static_cast<int>(gnomon::Failure::kInterrupted));
}

int say(const gnomon::cli::CommandLine& line) {
  if (line.exit_code == 0)
    return gnomon::cli::print(line.text) ? 0 : static_cast<int>(gnomon::Failure::kMachine);
  std::fputs(line.text.c_str(), stderr);
  return line.exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace gnomon;
  // Who was started with an interrupt ignored (nohup, a script's trap) is to stay so.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (::signal(signal, stop) == SIG_IGN) ::signal(signal, SIG_IGN);
  }
  ::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit fails instead, and is told
  const cli::CommandLine line = cli::parse_command_line(argc, argv, shader_library("/proc/self/exe"));
  return line.command ? cli::run(*line.command) : say(line);
}
