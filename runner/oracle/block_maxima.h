// SPDX-License-Identifier: MIT
// Highest sample over blocks of patches: lets the oracle pass over terrain that cannot hold the horizon.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "oracle/oracle.h"

namespace gnomon::oracle {

/// Block b of an axis holds the patches b * kSize .. b * kSize + kSize - 1.
class BlockMaxima {
 public:
  static constexpr int kSize = 16;

  explicit BlockMaxima(const Surface& surface);

  /// Highest corner of any patch of the block, metres; a bound of its bilinear surface.
  [[nodiscard]] double highest(int block_column, int block_row) const {
    return maxima_[static_cast<std::size_t>(block_row) * columns_ + static_cast<std::size_t>(block_column)];
  }

  /// Highest sample of the map, metres.
  [[nodiscard]] double highest() const { return highest_; }

 private:
  std::size_t columns_;
  std::vector<float> maxima_;
  double highest_;
};

}  // namespace gnomon::oracle
