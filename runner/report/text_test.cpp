// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "report/report.h"

namespace gnomon::report {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TestResult failed_test() {
  return {.id = "relief/cone@elevation=10,q=2",
          .scene_file = "testcases/relief/cone.json",
          .description = "Shadow of a cone",
          .status = Status::kFailed,
          .error = {},
          .verdicts = {{.expectation = "golden",
                        .passed = false,
                        .measured = "9 of 65536 pixels differ (0.0137 %)",
                        .limit = "at most 0",
                        .worst = judge::WorstPixel{12, 30, "k_shadow", double{0.4F}, 1},
                        .mismatches = 9,
                        .compared = 65536},
                       {.expectation = "max_steps 400",
                        .passed = true,
                        .measured = "up to 57 steps, at (1, 2)",
                        .limit = "at most 400 steps"}},
          .reproduce = "gnomon test --filter 'relief/cone@elevation=10,q=2'",
          .accept = "gnomon test --update-goldens changed --filter 'relief/cone@elevation=10,q=2'",
          .golden_note = {},
          .actual_exr = "report/relief/cone-actual.exr",
          .expected_exr = "goldens/relief/cone.exr",
          .difference_png = "report/relief/cone-difference.png",
          .actual_png = {},
          .expected_png = {},
          .seconds = 0.25};
}

TEST(FailureText, SaysAllThatAPersonNeeds) {
  const TestResult result = failed_test();
  const std::string text = failure_text(result);
  for (const std::string& part :
       {result.id, std::string("golden: 9 of 65536 pixels differ (0.0137 %), limit: at most 0"),
        std::string("worst pixel (12, 30): k_shadow is 0.4, expected 1"), result.reproduce, result.accept,
        result.actual_exr, result.expected_exr, result.difference_png, result.scene_file}) {
    EXPECT_TRUE(contains(text, part)) << part << "\nis not in\n" << text;
  }
  EXPECT_EQ(text.back(), '\n');
}

TEST(FailureText, LeavesOutWhatHeldAndWhatThereIsNot) {
  TestResult result = failed_test();
  result.accept.clear();
  const std::string text = failure_text(result);
  EXPECT_FALSE(contains(text, "max_steps"));
  EXPECT_FALSE(contains(text, "accept"));
}

TEST(FailureText, IndentsAnErrorOfSeveralLines) {
  TestResult result = failed_test();
  result.status = Status::kMachine;
  result.error = "worker died: signal 11\nlast line";
  EXPECT_TRUE(
      failure_text(result).starts_with("machine failed: relief/cone@elevation=10,q=2\n"
                                       "  worker died: signal 11\n  last line\n"));
}

TEST(SummaryLine, IsPassedAndFailed) {
  std::vector<TestResult> results(118);
  EXPECT_EQ(summary_line(results), "118 passed, 0 failed");
  results.push_back({.status = Status::kFailed});
  results.push_back({.status = Status::kInvalid});
  results.push_back({.status = Status::kMachine});
  EXPECT_EQ(summary_line(results), "118 passed, 3 failed");
  results.push_back({.status = Status::kSkipped});
  EXPECT_EQ(summary_line(results), "118 passed, 3 failed, 1 skipped");
  EXPECT_EQ(summary_line({}), "0 passed, 0 failed");
}

}  // namespace
}  // namespace gnomon::report
