// SPDX-License-Identifier: MIT
// Levels of detail H_q of a height map (paper 003, section 3; our own definition for sizes that are not
// powers of two).
#pragma once

#include "terrain/height_map.h"

namespace gnomon::terrain {

/// L = ceil(log2(max(width, height))): the level that has one sample.
[[nodiscard]] int coarsest_level(int width, int height);

/// H_q, 0 <= q <= coarsest_level. A sample of H_{k+1} is the mean of its up to 2x2 children of H_k, in
/// float32 as
/// ((NW + NE) + (SW + SE)) * (1/n) with 0 for an absent child (beyond the edge, or no sample): bit-identical
/// with programs/level.frag. Without a child there is no sample.
[[nodiscard]] HeightMap level(const HeightMap& base, int q);

}  // namespace gnomon::terrain
