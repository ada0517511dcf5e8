// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "judge/number_text.h"
#include "report/report.h"

namespace gnomon::report {
namespace {

/// Every further line of `text` as far to the right as its first.
std::string indented(const std::string& text, std::size_t columns) {
  std::string result;
  for (const char c : text) {
    result += c;
    if (c == '\n') result.append(columns, ' ');
  }
  return result;
}

std::string verdict_text(const judge::Verdict& verdict) {
  std::string text =
      fmt::format("  {}: {}, limit: {}\n", verdict.expectation, verdict.measured, verdict.limit);
  if (verdict.worst) text += fmt::format("    worst pixel {}\n", worst_pixel_text(*verdict.worst));
  return text;
}

}  // namespace

std::string status_text(Status status) {
  switch (status) {
    case Status::kPassed:
      return "passed";
    case Status::kFailed:
      return "failed";
    case Status::kInvalid:
      return "invalid";
    case Status::kSkipped:
      return "skipped";
    case Status::kMachine:
      return "machine failed";
  }
  return "unknown";
}

std::string worst_pixel_text(const judge::WorstPixel& worst) {
  return fmt::format("({}, {}): {} is {}, expected {}", worst.x, worst.y, worst.channel,
                     judge::number_text(worst.actual), judge::number_text(worst.expected));
}

std::string failure_text(const TestResult& result) {
  std::string text = fmt::format("{}: {}\n", status_text(result.status), result.id);
  if (!result.error.empty()) text += fmt::format("  {}\n", indented(result.error, 2));
  for (const judge::Verdict& verdict : result.verdicts) {
    if (!verdict.passed) text += verdict_text(verdict);
  }
  const std::pair<const char*, const std::string&> lines[] = {
      {"scene", result.scene_file},  {"reproduce", result.reproduce},
      {"accept", result.accept},     {"expected", result.expected_exr},
      {"actual", result.actual_exr}, {"difference", result.difference_png}};
  for (const auto& [name, value] : lines) {
    if (!value.empty()) text += fmt::format("  {:<12}{}\n", fmt::format("{}:", name), value);
  }
  return text;
}

std::string summary_line(const std::vector<TestResult>& results) {
  const auto count = [&](Status status) {
    return std::count_if(results.begin(), results.end(),
                         [&](const TestResult& r) { return r.status == status; });
  };
  const auto passed = count(Status::kPassed);
  const auto skipped = count(Status::kSkipped);
  const auto failed = static_cast<std::ptrdiff_t>(results.size()) - passed - skipped;
  std::string line = fmt::format("{} passed, {} failed", passed, failed);
  if (skipped > 0) line += fmt::format(", {} skipped", skipped);
  return line;
}

}  // namespace gnomon::report
