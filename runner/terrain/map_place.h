// SPDX-License-Identifier: MIT
// Where on the earth a height map lies, and how its grid is turned against the meridian there.
#pragma once

#include <optional>
#include <string>

#include "terrain/georeference.h"
#include "terrain/load.h"

namespace gnomon::terrain {

/// The middle of a height map.
struct MapPlace {
  double latitude = 0;   ///< degrees, geodetic, of the map's own datum
  double longitude = 0;  ///< degrees east of Greenwich, in [-180, 180)
  /// Meridian convergence: degrees from true north clockwise to grid north, in [-180, 180].
  double convergence = 0;
};

/// The middle of a map of `width` x `height` samples. Nothing where the coordinate system is missing,
/// unreadable, neither projected nor geographic or another body's, or where the middle lies outside of it.
[[nodiscard]] std::optional<MapPlace> place_of(const Georeference& georeference, int width, int height);

/// The same by a file's header alone; nothing where it cannot be read or names no place.
[[nodiscard]] std::optional<MapPlace> height_map_place(const std::string& path, const LoadOptions& options);

}  // namespace gnomon::terrain
