// SPDX-License-Identifier: MIT
#include "terrain/level.h"

#include <algorithm>
#include <array>

namespace gnomon::terrain {
namespace {

/// The mean of the children of sample (row, column) of the next level; an absent child (beyond an odd size,
/// or no sample) counts 0.
float mean_of_children(const HeightMap& map, int row, int column) {
  const int north = 2 * row;
  const int west = 2 * column;
  const bool has_south = north + 1 < map.height;
  const bool has_east = west + 1 < map.width;
  int children = 0;
  const auto child = [&](bool inside, int child_row, int child_column) {
    const float height = inside ? map.at(child_row, child_column) : kNoSample;
    children += is_sample(height) ? 1 : 0;
    return is_sample(height) ? height : 0.0f;
  };
  const float nw = child(true, north, west);
  const float ne = child(has_east, north, west + 1);
  const float sw = child(has_south, north + 1, west);
  const float se = child(has_east && has_south, north + 1, west + 1);
  constexpr std::array<float, 5> kShare{0.0f, 1.0f, 0.5f, 1.0f / 3.0f, 0.25f};
  if (children == 0) return kNoSample;
  return ((nw + ne) + (sw + se)) * kShare[static_cast<std::size_t>(children)];
}

HeightMap next_level(const HeightMap& map) {
  HeightMap next;
  next.width = (map.width + 1) / 2;
  next.height = (map.height + 1) / 2;
  next.spacing_x = map.spacing_x * 2.0;
  next.spacing_y = map.spacing_y * 2.0;
  next.domain_width = map.domain_width / 2.0;
  next.domain_height = map.domain_height / 2.0;
  next.holes = map.holes;
  next.samples.reserve(static_cast<std::size_t>(next.width) * static_cast<std::size_t>(next.height));
  for (int row = 0; row < next.height; ++row)
    for (int column = 0; column < next.width; ++column)
      next.samples.push_back(mean_of_children(map, row, column));
  return next;
}

}  // namespace

int coarsest_level(int width, int height) {
  int level = 0;
  for (int size = std::max(width, height); size > 1; size = (size + 1) / 2) ++level;
  return level;
}

HeightMap level(const HeightMap& base, int q) {
  HeightMap map = base;
  for (int k = 0; k < q; ++k) map = next_level(map);
  return map;
}

}  // namespace gnomon::terrain
