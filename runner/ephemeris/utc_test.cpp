// SPDX-License-Identifier: MIT
#include "ephemeris/utc.h"

#include <gtest/gtest.h>

namespace gnomon::ephemeris {
namespace {

/// What is read, written again; or why it is none.
std::string read(const std::string& text) {
  const Result<Utc> time = parse_utc(text);
  if (time) return to_string(*time);
  const std::string start = "expected a time in UTC such as 2024-06-21T12:00:00Z, got \"" + text + "\": ";
  const std::string& message = time.diagnostics().front().message;
  EXPECT_TRUE(message.starts_with(start)) << message;
  return message.substr(std::min(start.size(), message.size()));
}

TEST(Utc, ReadsEachFieldAndWritesOneTextForOneMoment) {
  const Result<Utc> time = parse_utc("2003-10-17T19:34:56.25Z");
  ASSERT_TRUE(time);
  EXPECT_EQ(*time, (Utc{2003, 10, 17, 19, 34, 56, 250000000}));
  EXPECT_EQ(to_string(*time), "2003-10-17T19:34:56.25Z");
  EXPECT_EQ(read("2024-06-21T12:00Z"), "2024-06-21T12:00:00Z");
  EXPECT_EQ(read("2024-06-21T12:00:00.000Z"), "2024-06-21T12:00:00Z");
  EXPECT_EQ(read("1999-12-31T23:59:59.999999999Z"), "1999-12-31T23:59:59.999999999Z");
}

TEST(Utc, KnowsTheLengthOfMonths) {
  for (const char* there : {"2024-02-29T00:00:00Z", "2000-02-29T00:00:00Z", "2023-04-30T00:00:00Z",
                            "2023-12-31T00:00:00Z", "1900-01-01T00:00:00Z", "2100-12-31T23:59:59Z"}) {
    EXPECT_EQ(read(there), there);
  }
  EXPECT_EQ(read("2023-02-29T00:00:00Z"), "February 2023 has the days 01 to 28");
  EXPECT_EQ(read("1900-02-29T00:00:00Z"), "February 1900 has the days 01 to 28");
  EXPECT_EQ(read("2024-02-30T00:00:00Z"), "February 2024 has the days 01 to 29");
  EXPECT_EQ(read("2024-04-31T00:00:00Z"), "April 2024 has the days 01 to 30");
  EXPECT_EQ(read("2024-01-00T00:00:00Z"), "January 2024 has the days 01 to 31");
}

TEST(Utc, RefusesWhatIsOutOfRange) {
  EXPECT_EQ(read("1899-12-31T00:00:00Z"), "the sun's position is known for the years 1900 to 2100");
  EXPECT_EQ(read("2101-01-01T00:00:00Z"), "the sun's position is known for the years 1900 to 2100");
  EXPECT_EQ(read("2024-13-01T00:00:00Z"), "there is no month 13");
  EXPECT_EQ(read("2024-00-01T00:00:00Z"), "there is no month 00");
  EXPECT_EQ(read("2024-06-21T24:00:00Z"), "the hours are 00 to 23, not 24");
  EXPECT_EQ(read("2024-06-21T12:60:00Z"), "the minutes are 00 to 59, not 60");
  EXPECT_EQ(read("2016-12-31T23:59:60Z"), "the seconds are 00 to 59, not 60; leap seconds are not taken");
}

TEST(Utc, TakesNoLocalTime) {
  EXPECT_EQ(read("2024-06-21T12:00:00"),
            "the Z at the end is missing, which says that it is UTC and no local time");
  EXPECT_EQ(read("2024-06-21T12:00:00+02:00"),
            "take the offset +02:00 off the time and write Z in its place");
  EXPECT_EQ(read("2024-06-21T12:00:00z"), "nothing but Z may follow the time, not \"z\"");
  EXPECT_EQ(read("2024-06-21T12:00:00Z "), "nothing but Z may follow the time, not \"Z \"");
}

TEST(Utc, RefusesOtherShapes) {
  for (const char* text : {"", "2024", "24-06-21T12:00:00Z", "2024-6-21T12:00:00Z", "2024/06/21T12:00:00Z",
                           " 2024-06-21T12:00:00Z", "-024-06-21T12:00:00Z", "+024-06-21T12:00:00Z", "now"}) {
    EXPECT_EQ(read(text), "it has to begin with a date, YYYY-MM-DD") << text;
  }
  for (const char* text :
       {"2024-06-21", "2024-06-21 12:00:00Z", "2024-06-21t12:00:00Z", "2024-06-211T12:00Z"})
    EXPECT_EQ(read(text), "a T and a time have to follow the date, hh:mm or hh:mm:ss") << text;
  for (const char* text : {"2024-06-21T", "2024-06-21T12Z", "2024-06-21T1:00Z", "2024-06-21T12:0Z",
                           "2024-06-21T12:00:0Z", "2024-06-21T12:00:00.Z", "2024-06-21T12:00:00.1234567890Z",
                           "2024-06-21T12:00:-1Z", "2024-06-21T120000Z"}) {
    EXPECT_EQ(read(text), "the time of day has to be hh:mm, hh:mm:ss or hh:mm:ss.f with at most 9 digits")
        << text;
  }
}

std::string part(const char* from, const char* to, int step, int steps) {
  return to_string(between(*parse_utc(from), *parse_utc(to), step, steps));
}

TEST(Utc, BetweenTwoTimesCountsEvenly) {
  EXPECT_EQ(part("2024-06-21T06:00:00Z", "2024-06-21T18:00:00Z", 1, 2), "2024-06-21T12:00:00Z");
  EXPECT_EQ(part("2024-06-21T06:00:00Z", "2024-06-21T07:00:00Z", 2, 3), "2024-06-21T06:40:00Z");
  EXPECT_EQ(part("2024-06-21T06:00:00Z", "2024-06-21T06:00:00Z", 1, 2), "2024-06-21T06:00:00Z");
  EXPECT_EQ(part("2024-06-21T22:00:00Z", "2024-06-22T04:00:00Z", 1, 2), "2024-06-22T01:00:00Z");
  EXPECT_EQ(part("2024-12-31T23:59:59Z", "2025-01-01T00:00:02Z", 1, 2), "2025-01-01T00:00:00.5Z");
  EXPECT_EQ(part("2024-02-28T12:00:00Z", "2024-03-01T12:00:00Z", 1, 2), "2024-02-29T12:00:00Z");
  EXPECT_EQ(part("2023-02-28T12:00:00Z", "2023-03-01T12:00:00Z", 1, 2), "2023-03-01T00:00:00Z");
  EXPECT_EQ(part("2024-06-22T04:00:00Z", "2024-06-21T22:00:00Z", 1, 3), "2024-06-22T02:00:00Z") << "back";
}

TEST(Utc, BetweenTwoTimesIsExactToTheNanosecond) {
  EXPECT_EQ(part("2024-06-21T06:00:00Z", "2024-06-21T06:00:01Z", 1, 3), "2024-06-21T06:00:00.333333333Z");
  EXPECT_EQ(part("2024-06-21T06:00:00Z", "2024-06-21T06:00:01Z", 2, 3), "2024-06-21T06:00:00.666666667Z");
  EXPECT_EQ(part("2024-06-21T06:00:01Z", "2024-06-21T06:00:00Z", 2, 3), "2024-06-21T06:00:00.333333333Z");
  // The longest way: 73,414 days less a nanosecond.
  const char *first = "1900-01-01T00:00:00Z", *last = "2100-12-31T23:59:59.999999999Z";
  EXPECT_EQ(part(first, last, 0, 10000), first);
  EXPECT_EQ(part(first, last, 10000, 10000), last);
  EXPECT_EQ(part(last, first, 10000, 10000), first);
  EXPECT_EQ(part(first, last, 1, 73414), "1900-01-02T00:00:00Z");
  EXPECT_EQ(part(last, first, 73413, 73414), "1900-01-02T00:00:00Z");
}

}  // namespace
}  // namespace gnomon::ephemeris
