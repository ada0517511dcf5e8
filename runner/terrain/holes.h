// SPDX-License-Identifier: MIT
// Where a map with holes has a surface (docs/algorithms.md, "Holes").
#pragma once

#include "terrain/height_map.h"

namespace gnomon::terrain {

/// Whether there is a surface at (column, row), in texels of this level: whether one of the patches there,
/// edges included, has four samples.
[[nodiscard]] bool has_surface(const HeightMap& map, double column, double row);

}  // namespace gnomon::terrain
