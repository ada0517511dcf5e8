// SPDX-License-Identifier: MIT
// A height map as the oracle sees it.
#pragma once

#include "oracle/oracle.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// A view of `map`, which has to outlive it.
[[nodiscard]] inline oracle::Surface surface_of(const terrain::HeightMap& map) {
  return {.width = map.width,
          .height = map.height,
          .spacing_x = map.spacing_x,
          .spacing_y = map.spacing_y,
          .domain_width = map.domain_width,
          .domain_height = map.domain_height,
          .samples = map.samples};
}

}  // namespace gnomon::technique
