// SPDX-License-Identifier: MIT
// The program, for tests: run as from a shell.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "temporary_tree.h"

namespace gnomon {

struct Outcome {
  int code = 0;  ///< -1 where a signal ended it
  std::string out;
  std::string err;
};

/// Runs `program` in the folder of the tree; `arguments` go through the shell.
inline Outcome run_in(const TemporaryTree& tree, const std::string& program, const std::string& arguments) {
  const std::string command =
      "cd '" + tree.path("") + "' && '" + program + "' " + arguments + " > stdout.txt 2> stderr.txt";
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, tree.read("stdout.txt"), tree.read("stderr.txt")};
}

}  // namespace gnomon
