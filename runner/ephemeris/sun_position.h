// SPDX-License-Identifier: MIT
// Where the sun stands at a time, seen from a place on the earth. docs/algorithms.md, "Sun by time and
// place", says how, and how exactly.
#pragma once

#include <string>

#include "ephemeris/utc.h"

namespace gnomon::ephemeris {

struct Place {
  double latitude = 0;   ///< geodetic, degrees, in [-90, 90], north positive
  double longitude = 0;  ///< degrees, east positive
  friend bool operator==(const Place&, const Place&) = default;
};

struct SunPosition {
  double azimuth = 0;    ///< of the sun's centre, degrees clockwise from true north, in [0, 360)
  double elevation = 0;  ///< geometric, above the plane that touches the ellipsoid: degrees, in [-90, 90]
};

/// As an observer on the ellipsoid sees the sun through no air. `time` is one that parse_utc gives. By the
/// library ERFA.
[[nodiscard]] SunPosition sun_position(const Utc& time, const Place& place);

/// By how many degrees the air lifts the sun, at its geometric elevation in degrees; never negative. 1010 hPa
/// and 10 degrees Celsius at the observer: Saemundsson, Sky & Telescope 72 (1986), page 70.
[[nodiscard]] double refraction(double elevation);

/// Of ERFA.
[[nodiscard]] std::string library_version();

}  // namespace gnomon::ephemeris
