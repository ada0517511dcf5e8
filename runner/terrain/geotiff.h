// SPDX-License-Identifier: MIT
// What GIS programs lay over the height map: one float channel as a GeoTIFF.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "gnomon/diagnostic.h"
#include "terrain/georeference.h"

namespace gnomon::terrain {

/// Says "no surface here" in the files that write_geotiff makes; declared by their tag.
constexpr float kTiffNodata = -9999.0F;

/// The georeference of an image of width x height pixels over the whole of a map of map_width x map_height
/// samples: the same extent.
[[nodiscard]] Georeference resized(const Georeference& map, int map_width, int map_height, int width,
                                   int height);

/// Writes width * height values (row 0 = north) as 32-bit floats; byte-identical for equal input. Atomic: on
/// failure (Failure::kMachine) an older file stays. Fails too where a value is not finite or their number is
/// another.
[[nodiscard]] Result<Done> write_geotiff(const std::string& path, int width, int height,
                                         std::span<const float> values,
                                         const std::optional<Georeference>& georeference);

}  // namespace gnomon::terrain
