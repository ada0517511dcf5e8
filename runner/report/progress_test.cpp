// SPDX-License-Identifier: MIT
#include "report/progress.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon::report {
namespace {

constexpr std::string_view kClearLine = "\r\x1b[2K";

TEST(Progress, RewritesOneLineOnATerminal) {
  const Progress progress{.finished = 12, .total = 120, .terminal = true};
  EXPECT_EQ(test_begun(progress, "a/b@q=2"), std::string(kClearLine) + "[ 12/120] a/b@q=2 ...");
  EXPECT_EQ(test_finished(progress, {.id = "a/b@q=2"}), "");
  EXPECT_EQ(run_finished(progress), kClearLine);
}

TEST(Progress, NeverFillsTheLastColumn) {
  const std::string id = std::string(200, 'a') + "@elevation=10,q=2";
  for (int columns = 20; columns < 250; ++columns) {
    const std::string line =
        test_begun({.finished = 3, .total = 10, .terminal = true, .columns = columns}, id);
    EXPECT_LT(line.size() - kClearLine.size(), static_cast<std::size_t>(columns));
  }
  const std::string line = test_begun({.finished = 3, .total = 10, .terminal = true, .columns = 60}, id);
  EXPECT_TRUE(line.ends_with("@elevation=10,q=2 ...")) << "the end tells a matrix's tests apart";
}

TEST(Progress, SurvivesATerminalWithoutRoom) {
  for (const int columns : {-1, 0, 1, 14}) {
    EXPECT_FALSE(test_begun({.total = 10, .terminal = true, .columns = columns}, "some/long/id").empty());
  }
}

TEST(Progress, CutsNoCharacterApart) {
  std::string id;
  for (int i = 0; i < 60; ++i) id += "\xC3\xA9";  // e with acute accent
  for (int columns = 20; columns < 60; ++columns) {
    const std::string line = test_begun({.total = 10, .terminal = true, .columns = columns}, id);
    EXPECT_EQ(std::count(line.begin(), line.end(), '\xC3'), std::count(line.begin(), line.end(), '\xA9'));
  }
}

TEST(Progress, AFailureKeepsItsLine) {
  const TestResult result{.id = "a/b", .status = Status::kFailed};
  EXPECT_EQ(test_finished({.finished = 7, .total = 120}, result), "[  7/120] failed  a/b\n");
  EXPECT_EQ(test_finished({.finished = 7, .total = 120, .terminal = true}, result),
            std::string(kClearLine) + "[  7/120] failed  a/b\n");
}

TEST(Progress, IsQuietOffATerminal) {
  std::string log;
  for (std::size_t i = 1; i <= 120; ++i) {
    const Progress progress{.finished = i, .total = 120};
    log += test_begun(progress, "a") + test_finished(progress, {.id = "a"});
  }
  log += run_finished({.finished = 120, .total = 120});
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 10);
  EXPECT_TRUE(log.starts_with("[ 12/120] ...\n"));
  EXPECT_TRUE(log.ends_with("[120/120] ...\n"));
  EXPECT_EQ(log.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace gnomon::report
