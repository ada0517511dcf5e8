// SPDX-License-Identifier: MIT
// Programs as a user meets them: exit code and all that they print.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace gnomon::testing {

struct Ran {
  int code = -1;       ///< 1000 and the signal where one ended it
  std::string output;  ///< standard output and standard error
};

/// Runs a command line of the shell without standard input.
inline Ran run_command(const std::string& command) {
  Ran ran;
  FILE* pipe = popen(("{ " + command + "; } 2>&1 </dev/null").c_str(), "r");
  if (!pipe) return ran;
  std::array<char, 4096> bytes{};
  while (const std::size_t count = fread(bytes.data(), 1, bytes.size(), pipe))
    ran.output.append(bytes.data(), count);
  const int status = pclose(pipe);
  ran.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  return ran;
}

}  // namespace gnomon::testing

#define EXPECT_SAYS(ran, text) EXPECT_NE((ran).output.find(text), std::string::npos) << (ran).output
