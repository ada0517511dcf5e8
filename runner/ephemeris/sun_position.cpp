// SPDX-License-Identifier: MIT
#include "ephemeris/sun_position.h"

#include <erfa.h>
#include <erfaextra.h>
#include <erfam.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace gnomon::ephemeris {
namespace {

constexpr double kRadians = std::numbers::pi / 180.0;

/// What ERFA needs to turn directions for this observer. Its status says whether the time lies outside of the
/// years for which leap seconds are tabled; the answer is usable there, see docs/algorithms.md.
eraASTROM observer(const Utc& time, const Place& place) {
  double day = 0, fraction = 0;
  static_cast<void>(eraDtf2d("UTC", time.year, time.month, time.day, time.hour, time.minute,
                             time.second + time.nanosecond * 1e-9, &day, &fraction));
  constexpr double kUt1LessUtc = 0.0, kHeight = 0.0, kPolarMotion = 0.0;
  constexpr double kPressure = 0.0;  // no air: the elevation stays geometric
  eraASTROM context{};
  double equation_of_origins = 0;
  static_cast<void>(eraApco13(day, fraction, kUt1LessUtc, place.longitude * kRadians,
                              place.latitude * kRadians, kHeight, kPolarMotion, kPolarMotion, kPressure, 0.0,
                              0.0, 0.55, &context, &equation_of_origins));
  return context;
}

}  // namespace

SunPosition sun_position(const Utc& time, const Place& place) {
  eraASTROM context = observer(time, place);
  // From the observer to the sun's centre. That the sun moves by some 8 km about the barycentre while its
  // light travels is less than 0.02 arc seconds.
  std::array<double, 3> natural{-context.eh[0], -context.eh[1], -context.eh[2]};
  std::array<double, 3> proper{}, intermediate{};
  eraAb(natural.data(), context.v, context.em, context.bm1, proper.data());
  eraRxp(context.bpn, proper.data(), intermediate.data());
  double right_ascension = 0, declination = 0;
  eraC2s(intermediate.data(), &right_ascension, &declination);
  double azimuth = 0, zenith_distance = 0, hour_angle = 0, observed_declination = 0, observed_ascension = 0;
  eraAtioq(right_ascension, declination, &context, &azimuth, &zenith_distance, &hour_angle,
           &observed_declination, &observed_ascension);
  const double degrees = azimuth / kRadians;
  return {degrees < 360.0 ? degrees : 0.0, std::clamp(90.0 - zenith_distance / kRadians, -90.0, 90.0)};
}

double refraction(double elevation) {
  // Below -1 degree the formula soon meets its pole; what it says there is kept, so that the lifted sun still
  // sinks with the sun. At the zenith it would fall below zero.
  const double e = std::max(elevation, -1.0);
  const double minutes = 1.02 / std::tan((e + 10.3 / (e + 5.11)) * kRadians);
  return std::max(minutes, 0.0) / 60.0;
}

std::string library_version() {
  return eraVersion();
}

}  // namespace gnomon::ephemeris
