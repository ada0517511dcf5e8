// SPDX-License-Identifier: MIT
// A moment in Coordinated Universal Time, as people write it.
#pragma once

#include <string>
#include <string_view>

#include "gnomon/diagnostic.h"

namespace gnomon::ephemeris {

/// The years that the theory of the Earth's motion behind sun_position covers.
constexpr int kFirstYear = 1900;
constexpr int kLastYear = 2100;

/// A date of the Gregorian calendar and a time of that day. Without leap seconds: a second is 0 to 59.
struct Utc {
  int year = 2000, month = 1, day = 1;
  int hour = 0, minute = 0, second = 0;
  int nanosecond = 0;
  friend bool operator==(const Utc&, const Utc&) = default;
};

/// Reads YYYY-MM-DDThh:mm[:ss[.fraction]]Z (ISO 8601, extended format), 1 to 9 digits of a fraction. Fails,
/// without a file's name, where it is anything else or no date of these years.
[[nodiscard]] Result<Utc> parse_utc(std::string_view text);

/// "2024-06-21T12:00:00Z", with a fraction of a second only where there is one: one text for each moment.
[[nodiscard]] std::string to_string(const Utc& time);

/// The moment after `step` of the `steps` equal parts of the way from one to another, to the nearest
/// nanosecond; `to` may be the earlier one. Every day has 86,400 seconds here: leap seconds are not counted.
/// Both are times that parse_utc gives, and 0 <= step <= steps, 0 < steps <= 10^9.
[[nodiscard]] Utc between(const Utc& from, const Utc& to, int step, int steps);

}  // namespace gnomon::ephemeris
