// SPDX-License-Identifier: MIT
// Height maps from image files: PNG (8/16 bit), EXR and TIFF, through OpenImageIO.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "terrain/height_map.h"

namespace gnomon::terrain {

struct LoadOptions {
  std::optional<std::array<double, 2>>
      spacing;                         ///< metres per sample (x, y); without it 1 m, said in `notes`
  double vertical_scale = 1.0;         ///< metres per stored unit
  std::optional<std::string> channel;  ///< picks one channel of a many-channel image
  int max_size = 16384;                ///< longest side that is accepted; the message names it
};

struct LoadedHeightMap {
  HeightMap map;
  std::vector<std::string> notes{};  ///< what a user should know, such as an assumed spacing
};

/// Stored number (integer images) or value (float images) times vertical_scale, combined in double, rounded
/// once to float32. Fails, never throws: unreadable, truncated, not an image, too large, several channels
/// without `channel`, a non-finite height (NaN marks nodata, which this version refuses), heights that
/// overflow float.
[[nodiscard]] Result<LoadedHeightMap> load_height_map(const std::string& path, const LoadOptions& options);

}  // namespace gnomon::terrain
