// SPDX-License-Identifier: MIT
// Pixels in the order in which programs walk for them fastest: those that ask one level side by side, and
// neighbours of the image beside each other, since graphics cards and their software walk in groups.
#pragma once

#include <set>
#include <vector>

#include "gl/draw.h"
#include "technique/ground.h"

namespace gnomon::technique {

/// The pixels of one level in a texture of points.
struct Band {
  int q = 0;
  gl::Window window{};
  /// A pixel of the image for each texel of the window, row by row. Where pixels do not fill a window, some
  /// stand there twice, and are answered alike.
  std::vector<std::size_t> pixels{};

  /// The texel of entry `i` of `pixels`.
  [[nodiscard]] glm::ivec2 texel(std::size_t i) const {
    const auto width = static_cast<std::size_t>(window.size.x);
    return window.first + glm::ivec2(i % width, i / width);
  }
};

/// The bands of one texture; they do not overlap.
using PointList = std::vector<Band>;

/// Texels of its texture, at most kTile across and somewhat over twice that down.
[[nodiscard]] glm::ivec2 size_of(const PointList& list);

/// Every valid pixel of `ground` that asks for one of `levels`; none where there is no such pixel.
[[nodiscard]] std::vector<PointList> point_lists(const Ground& ground, const std::set<int>& levels);

}  // namespace gnomon::technique
