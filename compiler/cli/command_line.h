// SPDX-License-Identifier: MIT
// What a person typed after `gnomonc`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/error_format.h"
#include "gnomon/compiler/compiler.h"

namespace gnomon::cli {

struct Command {
  enum class Name { kBuild, kCheck, kCpp, kGraph, kList };
  Name name = Name::kList;
  std::vector<std::string> files;
  compiler::Options options;
  std::string output;      ///< empty: standard output
  std::string reflection;  ///< of build: where the reflection goes; empty: nowhere
  std::string depfile;     ///< of build: what `output` depends on; empty: not asked for
  bool dot = false;        ///< of graph: for Graphviz
  ErrorFormat error_format = ErrorFormat::kGcc;
};

/// A command, or why there is none: a text to print (--help, --version, wrong usage) and the exit code.
struct CommandLine {
  std::optional<Command> command;
  std::string text;
  int exit_code = 0;
};

/// `library_directory` goes into the options of the command.
[[nodiscard]] CommandLine parse_command_line(int argc, const char* const* argv,
                                             const std::string& library_directory);

}  // namespace gnomon::cli
