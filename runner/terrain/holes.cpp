// SPDX-License-Identifier: MIT
#include "terrain/holes.h"

#include <algorithm>
#include <cmath>

namespace gnomon::terrain {
namespace {

/// Patch p lies between the samples p - 1 and p; the outermost ones have the edge sample twice.
bool is_whole(const HeightMap& map, int patch_column, int patch_row) {
  const int west = std::clamp(patch_column - 1, 0, map.width - 1);
  const int east = std::clamp(patch_column, 0, map.width - 1);
  const int north = std::clamp(patch_row - 1, 0, map.height - 1);
  const int south = std::clamp(patch_row, 0, map.height - 1);
  return is_sample(map.at(north, west)) && is_sample(map.at(north, east)) && is_sample(map.at(south, west)) &&
         is_sample(map.at(south, east));
}

/// The patches of one axis that hold the coordinate: one, or on an edge two.
struct Patches {
  int first, last;
};
Patches patches_at(double texels) {
  const double sample = texels - 0.5;
  const double below = std::floor(sample);
  const int last = static_cast<int>(below) + 1;
  return {sample == below ? last - 1 : last, last};
}

}  // namespace

bool has_surface(const HeightMap& map, double column, double row) {
  const Patches columns = patches_at(column);
  const Patches rows = patches_at(row);
  for (int y = rows.first; y <= rows.last; ++y)
    for (int x = columns.first; x <= columns.last; ++x)
      if (is_whole(map, x, y)) return true;
  return false;
}

}  // namespace gnomon::terrain
