// SPDX-License-Identifier: MIT
// Height maps from files: PNG (8/16 bit) and EXR through OpenImageIO; TIFF, .hgt, ESRI ASCII grid and USGS
// DEM through GDAL; bare numbers by a stated layout.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "terrain/georeference.h"
#include "terrain/height_map.h"
#include "terrain/raw_layout.h"

namespace gnomon::terrain {

struct LoadOptions {
  /// Metres per sample (x, y). Without it by the file's georeference, else 1 m; either is said in `notes`.
  std::optional<std::array<double, 2>> spacing{};
  std::optional<double> vertical_scale{};  ///< metres per unit of the file, instead of the unit it names
  std::optional<std::string> channel{};    ///< picks one channel of a many-channel image
  std::optional<RawLayout> raw{};          ///< the file is bare numbers that lie so
  std::optional<double> nodata{};          ///< stored number that means "no data", beside the file's own
  int max_size = 16384;                    ///< longest side that is accepted; the message names it
};

struct LoadedHeightMap {
  HeightMap map;
  std::vector<std::string> notes{};  ///< what a user should know, such as where the spacing is from
  std::optional<Georeference> georeference{};
};

/// (stored * scale + offset) * vertical_scale with the file's own scale and offset, combined in double,
/// rounded once to float32. Integer images give the stored number. Fails, never throws: unreadable,
/// truncated, no height map, too large, several channels without `channel`, rotated, an infinite height,
/// heights that overflow float.
[[nodiscard]] Result<LoadedHeightMap> load_height_map(const std::string& path, const LoadOptions& options);

/// Samples from west to east and from north to south, by the file's header alone; nothing where it cannot be
/// read.
[[nodiscard]] std::optional<std::array<int, 2>> height_map_size(const std::string& path,
                                                                const LoadOptions& options);

}  // namespace gnomon::terrain
