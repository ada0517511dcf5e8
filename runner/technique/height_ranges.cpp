// SPDX-License-Identifier: MIT
#include "technique/height_ranges.h"

#include <algorithm>

#include "terrain/height_map.h"

namespace gnomon::technique {
namespace {

constexpr int kBlock = 32;  // samples a side

std::size_t index_of(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

void widen(std::optional<HeightRange>& range, HeightRange by) {
  range = range ? HeightRange{std::min(range->low, by.low), std::max(range->high, by.high)} : by;
}

}  // namespace

HeightRanges::HeightRanges(std::span<const float> samples, glm::ivec2 size)
    : blocks_((size + kBlock - 1) / kBlock), ranges_(index_of(0, blocks_.y, blocks_.x)) {
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const float height = samples[index_of(x, y, size.x)];
      if (terrain::is_sample(height))
        widen(ranges_[index_of(x / kBlock, y / kBlock, blocks_.x)], {height, height});
    }
  }
}

std::optional<HeightRange> HeightRanges::over(glm::ivec2 first, glm::ivec2 last) const {
  std::optional<HeightRange> range;
  const glm::ivec2 from = glm::clamp(first / kBlock, glm::ivec2(0), blocks_ - 1);
  const glm::ivec2 to = glm::clamp(last / kBlock, glm::ivec2(0), blocks_ - 1);
  for (int y = from.y; y <= to.y; ++y) {
    for (int x = from.x; x <= to.x; ++x) {
      if (const auto& block = ranges_[index_of(x, y, blocks_.x)]) widen(range, *block);
    }
  }
  return range;
}

}  // namespace gnomon::technique
