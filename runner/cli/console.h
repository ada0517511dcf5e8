// SPDX-License-Identifier: MIT
// What a command gets from main: where to print, and what only a program knows of itself.
#pragma once

#include <atomic>
#include <istream>
#include <ostream>
#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon::cli {

struct Console {
  std::istream& in;
  std::ostream& out;
  std::ostream& err;
  bool terminal = false;       ///< progress may be rewritten in place
  int columns = 80;            ///< of the terminal
  std::string program;         ///< as the user typed it
  std::string executable;      ///< the file that is running
  std::string shader_library;  ///< folder of the modules
  const std::atomic<bool>& interrupted;
};

/// The code that outranks the other: 130, 99, 2, 1, 77, 0 (docs/cli.md, "Exit codes").
[[nodiscard]] int worse(int a, int b);

/// Prints every diagnostic and returns the code that follows.
int report(Console& console, const Diagnostics& diagnostics);

/// Whether an output's name is "-", which stands for standard output.
[[nodiscard]] inline bool is_stdout(const std::string& output) {
  return output == "-";
}

/// Where people read beside an output for programs: standard error if that one takes standard output.
[[nodiscard]] std::ostream& people(Console& console, const std::string& output);

/// Writes a text to a file, whole or not at all, or to standard output. Fails (kMachine) where it cannot be
/// written; of standard output main says so.
[[nodiscard]] Result<Done> write_text(Console& console, const std::string& output, const std::string& text);

}  // namespace gnomon::cli
