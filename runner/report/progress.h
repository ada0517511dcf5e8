// SPDX-License-Identifier: MIT
// How far a test run has come: one line that is rewritten on a terminal, few lines elsewhere. Texts only; the
// caller writes them to its stream as they are.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "report/report.h"

namespace gnomon::report {

struct Progress {
  std::size_t finished = 0;  ///< tests that have an outcome, the one at hand included
  std::size_t total = 0;
  bool terminal = false;  ///< the stream is a terminal that understands ANSI escape sequences
  int columns = 80;       ///< of the terminal; a longer id loses its beginning
};

/// A test was begun: "[ 12/120] a/b@q=2 ..." in place of the line before; nothing elsewhere.
[[nodiscard]] std::string test_begun(const Progress& progress, std::string_view id);

/// A test has an outcome. One that did not pass gets a line of its own that stays: "[ 12/120] failed
/// a/b@q=2". Off a terminal every tenth of the run is a line too: "[ 12/120] ...", so that a log shows that
/// it goes on.
[[nodiscard]] std::string test_finished(const Progress& progress, const TestResult& result);

/// The run is over: removes the line from a terminal.
[[nodiscard]] std::string run_finished(const Progress& progress);

}  // namespace gnomon::report
