// SPDX-License-Identifier: MIT
// The sun against published positions and against what the sky does everywhere.
#include "ephemeris/sun_position.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::ephemeris {
namespace {

SunPosition sun(const std::string& time, const Place& place) {
  const Result<Utc> utc = parse_utc(time);
  EXPECT_TRUE(utc) << time;
  return sun_position(*utc, place);
}

/// The angle between two directions, degrees.
double between(const SunPosition& a, const SunPosition& b) {
  constexpr double kRadians = std::numbers::pi / 180;
  const double cosine = std::sin(a.elevation * kRadians) * std::sin(b.elevation * kRadians) +
                        std::cos(a.elevation * kRadians) * std::cos(b.elevation * kRadians) *
                            std::cos((a.azimuth - b.azimuth) * kRadians);
  return std::acos(std::clamp(cosine, -1.0, 1.0)) / kRadians;
}

// I. Reda and A. Andreas, Solar Position Algorithm for Solar Radiation Applications, NREL/TP-560-34302
// (2008), table A5.1: 17 October 2003, 12:30:30 at UTC - 7 h, 1830.14 m, 820 mbar, 11 degrees Celsius.
TEST(SunPosition, IsThatOfTheWorkedExampleOfNrel) {
  const SunPosition at = sun("2003-10-17T19:30:30Z", {39.742476, -105.1786});
  EXPECT_NEAR(at.azimuth, 194.340241, 0.0003);
  EXPECT_NEAR(at.elevation, 39.872046, 0.0003);
  const double thinner_air = 820.0 / 1010.0 * 283.0 / (273.0 + 11.0);
  const double lift = refraction(39.872046) * thinner_air;
  EXPECT_NEAR(lift, 0.016332, 2e-6);
  EXPECT_NEAR(90 - at.elevation - lift, 50.11162, 0.0003);
}

// Astronomical Almanac for 2024: equinoxes on 20 March 3:06 and 22 September 12:44, solstices on 20 June
// 20:51 and 21 December 9:20 UTC; obliquity 23.4385 degrees.
TEST(SunPosition, AtThePolesIsItsDeclinationLessTheParallax) {
  const Place north{90, 0}, south{-90, 0};
  constexpr double kParallax = 8.794 / 3600;
  for (const char* equinox : {"2024-03-20T03:06:00Z", "2024-09-22T12:44:00Z"}) {
    const double above = sun(equinox, north).elevation, below = sun(equinox, south).elevation;
    EXPECT_NEAR(above, -kParallax, 0.0004) << equinox;  // the declination changes by 0.00027 in a minute
    EXPECT_NEAR(above + below, -2 * kParallax, 0.00005) << equinox;
  }
  EXPECT_NEAR(sun("2024-06-20T20:51:00Z", north).elevation, 23.4385 - kParallax, 0.0005);
  EXPECT_NEAR(sun("2024-12-21T09:20:00Z", south).elevation, 23.4385 - kParallax, 0.0005);
  EXPECT_NEAR(sun("2024-12-21T09:20:00Z", north).elevation, -23.4385 - kParallax, 0.0005);
}

TEST(SunPosition, AtThePoleCirclesAtOneHeightOnTheSolstice) {
  double previous = sun("2024-06-20T12:51:00Z", {90, 0}).azimuth;
  for (int hour = 13; hour < 24; ++hour) {
    const SunPosition at = sun("2024-06-20T" + std::to_string(hour) + ":51:00Z", {90, 0});
    EXPECT_NEAR(at.elevation, 23.436, 0.002);
    EXPECT_NEAR(std::remainder(at.azimuth - previous, 360.0), 15.0, 0.003);  // clockwise, 15 degrees an hour
    previous = at.azimuth;
  }
}

// The equation of time's extremes: 3 November 2024, +16 min 25 s; 11 February 2024, -14 min 14 s. At these
// elevations a second is 0.005 degrees of azimuth in the north, 0.007 in the south.
TEST(SunPosition, CrossesTheMeridianAsTheEquationOfTimeSays) {
  constexpr double kGreenwich = 51.4779;
  for (const char* noon : {"2024-11-03T11:43:35Z", "2024-02-11T12:14:14Z"}) {
    EXPECT_NEAR(sun(noon, {kGreenwich, 0}).azimuth, 180, 0.03) << noon;
    EXPECT_NEAR(std::remainder(sun(noon, {-kGreenwich, 0}).azimuth, 360.0), 0, 0.03) << noon;
  }
}

TEST(SunPosition, OnTheEquatorAtAnEquinoxRisesEastAndSetsWest) {
  // Noon of Greenwich comes 7 min 26 s after 12:00 UTC that day.
  EXPECT_GT(sun("2024-03-20T12:07:26Z", {0, 0}).elevation, 89.8);
  const SunPosition morning = sun("2024-03-20T09:07:26Z", {0, 0});
  EXPECT_NEAR(morning.azimuth, 90, 0.2);
  EXPECT_NEAR(morning.elevation, 45, 0.05);
  const SunPosition evening = sun("2024-03-20T15:07:26Z", {0, 0});
  EXPECT_NEAR(evening.azimuth, 270, 0.3);
  EXPECT_NEAR(evening.elevation, 45, 0.05);
}

TEST(SunPosition, StandsInTheZenithOfTheTropicAtTheSolstice) {
  // 20 June 2024, 20:51 UTC: true noon is at 12:01:46 less 4 minutes for each degree east.
  const double minutes_after_noon = 20 * 60 + 51 - (12 * 60 + 1 + 46.0 / 60);
  EXPECT_GT(sun("2024-06-20T20:51:00Z", {23.438, -minutes_after_noon / 4}).elevation, 89.98);
}

TEST(SunPosition, TakesFifteenDegreesEastForAnHour) {
  for (const double latitude : {-77.0, -33.0, 0.0, 47.4, 65.0}) {
    for (const double longitude : {-165.0, -15.0, 0.0, 60.0, 150.0}) {
      const SunPosition here = sun("2024-09-10T10:00:00Z", {latitude, longitude});
      EXPECT_LT(between(here, sun("2024-09-10T09:00:00Z", {latitude, longitude + 15})), 0.02);
      EXPECT_LT(between(here, sun("2024-09-10T10:00:00Z", {latitude, longitude + 360})), 1e-6);
    }
  }
}

TEST(SunPosition, MovesSmoothlyThroughFractionsMidnightsAndYears) {
  const Place place{47.4, 8.5};
  for (const auto& [before, after] : {std::pair{"2024-06-21T11:59:59.5Z", "2024-06-21T12:00:00Z"},
                                      {"2024-02-29T23:59:59.5Z", "2024-03-01T00:00:00Z"},
                                      {"2016-12-31T23:59:59.5Z", "2017-01-01T00:00:00Z"},
                                      {"1959-12-31T23:59:59.5Z", "1960-01-01T00:00:00Z"},
                                      {"2099-12-31T23:59:59.5Z", "2100-01-01T00:00:00Z"}}) {
    // Half a second, or one and a half where a leap second lies between.
    const double moved = between(sun(before, place), sun(after, place));
    EXPECT_GT(moved, 0.001) << before;
    EXPECT_LT(moved, 0.007) << before;
  }
}

TEST(SunPosition, IsKnownInTheFirstAndTheLastYear) {
  // On 1 January the declination is -23.0 degrees and changes by 0.08 a day; the calendar strays from the
  // seasons by a day and a half within these years.
  for (const char* time : {"1900-01-01T12:00:00Z", "1950-01-01T12:00:00Z", "2100-01-01T12:00:00Z"})
    EXPECT_NEAR(sun(time, {90, 0}).elevation, -23.03, 0.12) << time;
}

TEST(Refraction, LiftsTheHorizonByHalfADegreeAndTheZenithByNothing) {
  EXPECT_NEAR(refraction(-34.0 / 60) * 60, 34, 0.5);  // almanacs: 34' at an apparent elevation of 0
  EXPECT_NEAR(refraction(10) * 60, 5.4, 0.1);
  EXPECT_NEAR(refraction(45) * 60, 1.0, 0.03);
  EXPECT_EQ(refraction(90), 0);
}

TEST(Refraction, KeepsTheOrderOfElevations) {
  double previous = -91;
  for (int i = -9000; i <= 9000; ++i) {
    const double elevation = i / 100.0, lifted = elevation + refraction(elevation);
    EXPECT_GT(lifted, previous) << elevation;
    EXPECT_LE(refraction(elevation), 0.7) << elevation;
    previous = lifted;
  }
}

}  // namespace
}  // namespace gnomon::ephemeris
