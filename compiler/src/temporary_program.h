// SPDX-License-Identifier: MIT
// A C++ program of a test's own, compiled and run.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "temporary_tree.h"

namespace gnomon {

/// Compiles `source` in the folder of the tree as a user would, with every warning an error, and runs it. Its
/// exit code; -1 where it does not compile or crashes.
inline int run_program(const TemporaryTree& tree, const std::string& source) {
  tree.file("main.cpp", source);
  const std::string folder = "cd '" + tree.path("") + "' && ";
  const std::string compile =
      "'" GNOMON_CXX
      "' -std=c++17 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion -Werror main.cpp -o main";
  if (std::system((folder + compile).c_str()) != 0) return -1;
  const int status = std::system((folder + "./main").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace gnomon
