// SPDX-License-Identifier: MIT
#include "report/test_result_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon::report {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TestResult full_result() {
  return {.id = "a/b@q=2",
          .scene_file = "testcases/a/b.json",
          .description = "quotes \" and \\ and\nlines\r\n\tand \x01 \x7F and \xE2\x98\x80",
          .status = Status::kInvalid,
          .error = "worker died: signal 11",
          .verdicts = {{.expectation = "golden",
                        .passed = true,
                        .measured = "0 of 1",
                        .limit = "at most 0",
                        .worst = judge::WorstPixel{3, 4, "b_shadow", 0.1, 1e-300},
                        .mismatches = 1,
                        .in_band = 2,
                        .compared = 3},
                       {.expectation = "probe (1, 2)"}},
          .reproduce = "r",
          .accept = "a",
          .golden_note = "written",
          .actual_exr = "1",
          .expected_exr = "2",
          .difference_png = "3",
          .actual_png = "4",
          .expected_png = "5",
          .seconds = 0.1 + 0.2};
}

TEST(TestResultJson, ReturnsWhatWasSent) {
  const TestResult sent = full_result();
  const std::string line = to_json(sent);
  const Result<TestResult> got = from_json(line);
  ASSERT_TRUE(got.ok());
  EXPECT_EQ(got->id, sent.id);
  EXPECT_EQ(got->scene_file, sent.scene_file);
  EXPECT_EQ(got->description, sent.description);
  EXPECT_EQ(got->status, sent.status);
  EXPECT_EQ(got->error, sent.error);
  EXPECT_EQ(got->reproduce, sent.reproduce);
  EXPECT_EQ(got->accept, sent.accept);
  EXPECT_EQ(got->golden_note, sent.golden_note);
  EXPECT_EQ(got->actual_exr, sent.actual_exr);
  EXPECT_EQ(got->expected_exr, sent.expected_exr);
  EXPECT_EQ(got->difference_png, sent.difference_png);
  EXPECT_EQ(got->actual_png, sent.actual_png);
  EXPECT_EQ(got->expected_png, sent.expected_png);
  EXPECT_EQ(got->seconds, sent.seconds);
  ASSERT_EQ(got->verdicts.size(), 2U);
  const judge::Verdict& verdict = got->verdicts[0];
  EXPECT_EQ(verdict.expectation, "golden");
  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.measured, "0 of 1");
  EXPECT_EQ(verdict.limit, "at most 0");
  EXPECT_EQ(verdict.mismatches, 1);
  EXPECT_EQ(verdict.in_band, 2);
  EXPECT_EQ(verdict.compared, 3);
  ASSERT_TRUE(verdict.worst);
  EXPECT_EQ(verdict.worst->x, 3);
  EXPECT_EQ(verdict.worst->y, 4);
  EXPECT_EQ(verdict.worst->channel, "b_shadow");
  EXPECT_EQ(verdict.worst->actual, 0.1);
  EXPECT_EQ(verdict.worst->expected, 1e-300);
  EXPECT_FALSE(got->verdicts[1].worst);
  EXPECT_EQ(to_json(*got), line);
}

TEST(TestResultJson, IsOneLine) {
  EXPECT_EQ(to_json(full_result()).find('\n'), std::string::npos);
}

TEST(TestResultJson, CarriesEveryStatus) {
  for (const Status status :
       {Status::kPassed, Status::kFailed, Status::kInvalid, Status::kSkipped, Status::kMachine}) {
    const Result<TestResult> got = from_json(to_json({.status = status}));
    ASSERT_TRUE(got.ok());
    EXPECT_EQ(got->status, status);
  }
}

TEST(TestResultJson, CarriesNumbersThatJsonHasNot) {
  for (const double number : {kInfinity, -kInfinity, -0.0, 5e-324, std::numeric_limits<double>::max()}) {
    const Result<TestResult> got = from_json(to_json({.seconds = number}));
    ASSERT_TRUE(got.ok());
    EXPECT_EQ(got->seconds, number);
    EXPECT_EQ(std::signbit(got->seconds), std::signbit(number));
  }
  const judge::Verdict verdict{.worst = judge::WorstPixel{.actual = std::nan("")}};
  const Result<TestResult> got = from_json(to_json({.verdicts = {verdict}}));
  ASSERT_TRUE(got.ok());
  EXPECT_TRUE(std::isnan(got->verdicts.at(0).worst->actual));
}

TEST(TestResultJson, TakesBytesThatAreNotUtf8) {
  const Result<TestResult> got =
      from_json(to_json({.id = "before \xFF\xC3 after", .error = std::string("a\0b", 3)}));
  ASSERT_TRUE(got.ok());
  EXPECT_TRUE(got->id.starts_with("before \xEF\xBF\xBD"));
  EXPECT_TRUE(got->id.ends_with(" after"));
  EXPECT_EQ(got->error, std::string("a\0b", 3));
}

TEST(TestResultJson, RefusesWhatIsNoResult) {
  const std::string line = to_json(full_result());
  for (std::size_t length = 0; length < line.size(); ++length) {
    const Result<TestResult> got = from_json(std::string_view(line).substr(0, length));
    ASSERT_FALSE(got.ok()) << "cut off after " << length;
    EXPECT_EQ(got.diagnostics().at(0).failure, Failure::kMachine);
  }
  for (const char* text : {"null", "[]", "{}", "\"id\"", "3", "{\"id\": 3}"})
    EXPECT_FALSE(from_json(text).ok());
}

TEST(TestResultJson, RefusesValuesOfTheWrongKind) {
  const auto with = [](std::string from, const std::string& to) {
    std::string line = to_json(full_result());
    const std::size_t at = line.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return from_json(line.replace(at, from.size(), to));
  };
  EXPECT_TRUE(with("\"x\":3", "\"x\":4").ok());
  EXPECT_FALSE(with("\"status\":\"invalid\"", "\"status\":\"odd\"").ok());
  EXPECT_FALSE(with("\"x\":3", "\"x\":\"3\"").ok());
  EXPECT_FALSE(with("\"in_band\":2.0", "\"in_band\":\"two\"").ok());
  EXPECT_FALSE(with("\"in_band\":2.0", "\"in_band\":null").ok());
  EXPECT_FALSE(with("\"passed\":true", "\"passed\":1").ok());
  EXPECT_FALSE(with("\"id\":\"a/b@q=2\"", "\"id\":7").ok());
}

}  // namespace
}  // namespace gnomon::report
