// SPDX-License-Identifier: MIT
// How long a metre of a map projection is on the ground.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "terrain/georeference.h"

namespace gnomon::terrain {

/// In the middle of a map.
struct GroundScale {
  /// Metres on the ellipsoid for a metre of the projection: along a row, along a column.
  std::array<double, 2> metres{1, 1};
  double corner = 90;  ///< degrees from a row counterclockwise to a column, on the ellipsoid
};

/// Nothing where the coordinate system is not a projected one, or its middle lies outside of it.
[[nodiscard]] std::optional<GroundScale> ground_scale(const Georeference& georeference, int width,
                                                      int height);

/// What a person should know of a map of `width` x `height` samples whose spacing, metres west to east and
/// north to south, is the projection's, where that differs from the ground's by more than 1 %; else nothing.
[[nodiscard]] std::optional<std::string> ground_scale_warning(const Georeference& georeference, int width,
                                                              int height, std::array<double, 2> spacing);

}  // namespace gnomon::terrain
