// SPDX-License-Identifier: MIT
// Where on the earth, or another body, a height map lies, and what that says of its spacing.
#pragma once

#include <array>
#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon::terrain {

/// Of a north-up map: the point (column, row), in texels from the north-west corner, lies at
/// x = transform[0] + column * transform[1], y = transform[3] + row * transform[5] of the coordinate system;
/// transform[5] < 0, and [2] and [4] are 0. GDAL's convention: corners of texels, not their middles.
struct Georeference {
  std::array<double, 6> transform{};
  std::string crs;  ///< WKT; empty where the file names no coordinate system
};

struct GeoreferencedSpacing {
  std::array<double, 2> metres{};  ///< between samples, west to east and north to south
  std::string how;                 ///< one sentence for a person
  std::string warning;             ///< one more where something is wrong with the georeference, else empty
};

/// Lengths of a radian on an ellipsoid at a geodetic latitude, metres: along the parallel, along the
/// meridian. `inverse_flattening` 0: a sphere. Snyder, Map Projections: A Working Manual (1987), eqs. 4-18
/// and 4-20.
[[nodiscard]] std::array<double, 2> radian_lengths(double semi_major, double inverse_flattening,
                                                   double latitude_radians);

/// Projected units in metres; degrees by the radii of the coordinate system's own ellipsoid at the map's
/// centre (`height`: rows); without a coordinate system metres are assumed, and said. Fails (without a file's
/// name) where the system has neither lengths nor angles, or the centre is no place on the ellipsoid or lies
/// within a row of a pole beyond which the map reaches; warns where the map reaches beyond one by more than a
/// row.
[[nodiscard]] Result<GeoreferencedSpacing> spacing_of(const Georeference& georeference, int height);

/// Metres per unit of the coordinate system's vertical axis; 1 where it has none.
[[nodiscard]] double vertical_unit(const std::string& crs);

}  // namespace gnomon::terrain
