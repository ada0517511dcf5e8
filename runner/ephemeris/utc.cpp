// SPDX-License-Identifier: MIT
#include "ephemeris/utc.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>

namespace gnomon::ephemeris {
namespace {

constexpr std::array kMonths{"January", "February", "March",     "April",   "May",      "June",
                             "July",    "August",   "September", "October", "November", "December"};

bool is_leap_year(int year) {
  return (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
}

int days_in(int year, int month) {
  if (month == 2) return is_leap_year(year) ? 29 : 28;
  return month == 4 || month == 6 || month == 9 || month == 11 ? 30 : 31;
}

Diagnostic not_a_time(std::string_view text, const std::string& why) {
  return {.message = fmt::format("expected a time in UTC such as 2024-06-21T12:00:00Z, got \"{}\": {}",
                                 text.substr(0, 60), why)};
}

/// Reads from the front of a text.
class Reader {
 public:
  explicit Reader(std::string_view rest) : rest_(rest) {}

  bool take(char expected) {
    if (rest_.empty() || rest_.front() != expected) return false;
    rest_.remove_prefix(1);
    return true;
  }

  /// Exactly `digits` decimal digits.
  std::optional<int> number(std::size_t digits) {
    if (rest_.size() < digits) return std::nullopt;
    int value = 0;
    for (const char c : rest_.substr(0, digits)) {
      if (c < '0' || c > '9') return std::nullopt;
      value = value * 10 + (c - '0');
    }
    rest_.remove_prefix(digits);
    return value;
  }

  /// 1 to 9 digits behind a decimal point, as billionths.
  std::optional<int> billionths() {
    int value = 0, digits = 0;
    for (std::optional<int> digit = number(1); digit; digit = number(1)) {
      if (++digits > 9) return std::nullopt;
      value = value * 10 + *digit;
    }
    if (digits == 0) return std::nullopt;
    for (; digits < 9; ++digits) value *= 10;
    return value;
  }

  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
};

bool read_date(Reader& reader, Utc& time) {
  const auto field = [&](int& into, std::size_t digits) {
    const std::optional<int> value = reader.number(digits);
    into = value.value_or(0);
    return value.has_value();
  };
  return field(time.year, 4) && reader.take('-') && field(time.month, 2) && reader.take('-') &&
         field(time.day, 2);
}

bool read_clock(Reader& reader, Utc& time) {
  const std::optional<int> hour = reader.number(2);
  const std::optional<int> minute = hour && reader.take(':') ? reader.number(2) : std::nullopt;
  if (!minute) return false;
  time.hour = *hour;
  time.minute = *minute;
  if (!reader.take(':')) return true;
  const std::optional<int> second = reader.number(2);
  time.second = second.value_or(0);
  if (!second || !reader.take('.')) return second.has_value();
  const std::optional<int> fraction = reader.billionths();
  time.nanosecond = fraction.value_or(0);
  return fraction.has_value();
}

/// What keeps fields of the right shape from being a moment; empty if nothing does.
std::string range_problem(const Utc& time) {
  if (time.year < kFirstYear || time.year > kLastYear)
    return fmt::format("the sun's position is known for the years {} to {}", kFirstYear, kLastYear);
  if (time.month < 1 || time.month > 12) return fmt::format("there is no month {:02}", time.month);
  const int days = days_in(time.year, time.month);
  if (time.day < 1 || time.day > days)
    return fmt::format("{} {} has the days 01 to {}", kMonths[std::size_t(time.month - 1)], time.year, days);
  if (time.hour > 23) return fmt::format("the hours are 00 to 23, not {:02}", time.hour);
  if (time.minute > 59) return fmt::format("the minutes are 00 to 59, not {:02}", time.minute);
  if (time.second > 59)
    return fmt::format("the seconds are 00 to 59, not {:02}; leap seconds are not taken", time.second);
  return {};
}

/// What is wrong with what follows the time; empty if it is the Z and nothing else.
std::string zone_problem(std::string_view rest) {
  if (rest == "Z") return {};
  if (rest.empty()) return "the Z at the end is missing, which says that it is UTC and no local time";
  if (rest.front() == '+' || rest.front() == '-')
    return fmt::format("take the offset {} off the time and write Z in its place", rest.substr(0, 10));
  return fmt::format("nothing but Z may follow the time, not \"{}\"", rest.substr(0, 20));
}

using Moment = std::chrono::sys_time<std::chrono::nanoseconds>;

Moment moment_of(const Utc& time) {
  const std::chrono::sys_days date{std::chrono::year(time.year) / time.month / time.day};
  return date + std::chrono::hours(time.hour) + std::chrono::minutes(time.minute) +
         std::chrono::seconds(time.second) + std::chrono::nanoseconds(time.nanosecond);
}

Utc utc_of(Moment moment) {
  const auto midnight = std::chrono::floor<std::chrono::days>(moment);
  const std::chrono::year_month_day date{midnight};
  const std::chrono::hh_mm_ss clock{moment - midnight};
  return {int(date.year()),
          int(unsigned(date.month())),
          int(unsigned(date.day())),
          int(clock.hours().count()),
          int(clock.minutes().count()),
          int(clock.seconds().count()),
          int(clock.subseconds().count())};
}

}  // namespace

Result<Utc> parse_utc(std::string_view text) {
  Reader reader(text);
  Utc time;
  if (!read_date(reader, time)) return not_a_time(text, "it has to begin with a date, YYYY-MM-DD");
  if (!reader.take('T')) return not_a_time(text, "a T and a time have to follow the date, hh:mm or hh:mm:ss");
  if (!read_clock(reader, time))
    return not_a_time(text, "the time of day has to be hh:mm, hh:mm:ss or hh:mm:ss.f with at most 9 digits");
  if (const std::string problem = range_problem(time); !problem.empty()) return not_a_time(text, problem);
  if (const std::string problem = zone_problem(reader.rest()); !problem.empty())
    return not_a_time(text, problem);
  return time;
}

std::string to_string(const Utc& time) {
  std::string text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}", time.year, time.month, time.day,
                                 time.hour, time.minute, time.second);
  if (time.nanosecond != 0) {
    text += fmt::format(".{:09}", time.nanosecond);
    text.erase(text.find_last_not_of('0') + 1);
  }
  return text + "Z";
}

Utc between(const Utc& from, const Utc& to, int step, int steps) {
  // In whole nanoseconds, of which 201 years fit a signed 64-bit integer; the product of both would not.
  const std::int64_t way = (moment_of(to) - moment_of(from)).count();
  const std::int64_t rest = way % steps * step, half = way < 0 ? -steps : steps;
  const std::int64_t gone = way / steps * step + (2 * rest + half) / (2 * std::int64_t{steps});
  return utc_of(moment_of(from) + std::chrono::nanoseconds(gone));
}

}  // namespace gnomon::ephemeris
