// SPDX-License-Identifier: MIT
#include "report/progress.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::report {
namespace {

constexpr std::string_view kClearLine = "\r\x1b[2K";  // ECMA-48: erase in line, all of it

std::string counter(const Progress& progress) {
  const std::size_t digits = fmt::formatted_size("{}", progress.total);
  return fmt::format("[{:>{}}/{}]", progress.finished, digits, progress.total);
}

/// At most `room` bytes: the end tells the tests of a matrix apart, so the beginning goes. Cuts no UTF-8
/// character.
std::string end_of(std::string_view id, std::size_t room) {
  constexpr std::string_view kCut = "...";
  if (id.size() <= room) return std::string(id);
  const auto is_continuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  std::size_t first = id.size() - (room > kCut.size() ? room - kCut.size() : 0);
  while (first < id.size() && is_continuation(id[first])) ++first;
  return std::string(kCut).append(id.substr(first));
}

/// Whether this test completes a further tenth of the run.
bool completes_a_tenth(const Progress& progress) {
  if (progress.total == 0 || progress.finished == 0) return false;
  const auto tenths = [&](std::size_t finished) { return 10 * finished / progress.total; };
  return tenths(progress.finished) > tenths(progress.finished - 1);
}

}  // namespace

std::string test_begun(const Progress& progress, std::string_view id) {
  if (!progress.terminal) return {};
  const std::string count = counter(progress);
  // A terminal wraps a line that fills its last column, and then could not be cleared.
  const std::size_t taken = count.size() + std::string_view(" ").size() + std::string_view(" ...").size() + 1;
  const auto columns = static_cast<std::size_t>(std::max(progress.columns, 0));
  return fmt::format("{}{} {} ...", kClearLine, count, end_of(id, columns > taken ? columns - taken : 0));
}

std::string test_finished(const Progress& progress, const TestResult& result) {
  if (result.status != Status::kPassed) {
    return fmt::format("{}{} {}  {}\n", progress.terminal ? kClearLine : "", counter(progress),
                       status_text(result.status), result.id);
  }
  return !progress.terminal && completes_a_tenth(progress) ? counter(progress) + " ...\n" : std::string();
}

std::string run_finished(const Progress& progress) {
  return std::string(progress.terminal ? kClearLine : "");
}

}  // namespace gnomon::report
