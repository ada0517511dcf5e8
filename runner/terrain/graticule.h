// SPDX-License-Identifier: MIT
// Coordinate systems, and the net of meridians and parallels below them. Internal to this folder.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>

#include "terrain/georeference.h"

namespace gnomon::terrain {

struct ReleaseCrs {
  void operator()(void* crs) const;
};
using Crs = std::unique_ptr<void, ReleaseCrs>;  ///< GDAL's OGRSpatialReferenceH

struct ReleaseTransformation {
  void operator()(void* transformation) const;
};
using Transformation = std::unique_ptr<void, ReleaseTransformation>;  ///< GDAL's OGRCoordinateTransformationH

/// The horizontal part of a coordinate system, with x (east, longitude) before y (north, latitude), as in a
/// geotransform, whatever order the authority has. Null where the text is empty or unreadable.
[[nodiscard]] Crs horizontal(const std::string& wkt);

/// What people know a coordinate system by.
[[nodiscard]] std::string name_of(const Crs& crs);

/// x and y of a coordinate system, in its own units.
using Point = std::array<double, 2>;

/// Nothing where the point lies outside of what the transformation covers.
[[nodiscard]] std::optional<Point> transformed(const Transformation& transformation, Point point);

/// Longitude and latitude, counted from the system's own prime meridian, and back.
struct Graticule {
  Transformation to_geographic;
  Transformation from_geographic;
  double unit = 1;            ///< degrees
  double prime_meridian = 0;  ///< degrees east of Greenwich
};

/// Nothing where the system has none.
[[nodiscard]] std::optional<Graticule> graticule_of(const Crs& crs);

/// The middle of a map of `width` x `height` samples, in units of its coordinate system.
[[nodiscard]] Point middle_of(const Georeference& georeference, int width, int height);

}  // namespace gnomon::terrain
