// SPDX-License-Identifier: MIT
// Lowest and highest samples by blocks of a map: what lets a renderer leave out the parts of a mesh that its
// view cannot hold.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <vector>

namespace gnomon::technique {

struct HeightRange {
  float low = 0;   ///< metres
  float high = 0;  ///< metres
};

class HeightRanges {
 public:
  /// `samples`: size.x * size.y heights in metres, row by row; those without data are left out.
  HeightRanges(std::span<const float> samples, glm::ivec2 size);

  /// Holds all samples from `first` to `last`, both included and cut to the map; may be wider, by the rest of
  /// the blocks that they lie in. Absent where there is no data.
  [[nodiscard]] std::optional<HeightRange> over(glm::ivec2 first, glm::ivec2 last) const;

 private:
  glm::ivec2 blocks_;
  std::vector<std::optional<HeightRange>> ranges_;
};

}  // namespace gnomon::technique
