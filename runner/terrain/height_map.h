// SPDX-License-Identifier: MIT
// The height map as everything downstream sees it: float32 metres, north row first.
#pragma once

#include <cstddef>
#include <vector>

namespace gnomon::terrain {

/// Largest absolute height that a map may have, metres: beyond any world, and small enough for every level
/// and every square of a slope to stay finite in single precision.
constexpr double kHighestHeight = 1e15;

/// What stands in `samples` where there is no data: GNOMON_NO_SAMPLE of the shader library. Far below any
/// height, so that a comparison tells it, and small enough for differences of two to stay finite.
constexpr float kNoSample = -1e30F;

[[nodiscard]] inline bool is_sample(float height) {
  return height > -1e20F;
}

/// A level of a height map (level 0 is the map itself). Sample (row i, column j) lies at column j + 0.5, row
/// i + 0.5, in texels of this level from the west and the north edge. The surface is the bilinear
/// interpolation of the samples, clamped to the edge, over 0..domain_width x 0..domain_height.
struct HeightMap {
  int width = 0;             ///< samples from west to east, >= 1
  int height = 0;            ///< samples from north to south, >= 1
  double spacing_x = 1.0;    ///< metres between samples, west to east; at level q: 2^q times the base map's
  double spacing_y = 1.0;    ///< metres between samples, north to south
  double domain_width = 0;   ///< texels of this level; `width` at level 0, base width / 2^q at level q
  double domain_height = 0;  ///< texels of this level; `height` at level 0, base height / 2^q at level q
  std::vector<float>
      samples;  ///< width * height heights in metres (or kNoSample), row-major, row 0 = north; all finite
  bool holes = false;  ///< whether some are kNoSample

  [[nodiscard]] float at(int row, int column) const {
    return samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
  }
};

}  // namespace gnomon::terrain
