// SPDX-License-Identifier: MIT
#include "oracle/block_maxima.h"

#include <algorithm>

namespace gnomon::oracle {
namespace {

// Corners of patch p are the samples p - 1 and p, so a block needs one sample before its first patch.
float highest_of_block(const Surface& surface, int block_column, int block_row) {
  const int size = BlockMaxima::kSize;
  const int west = std::max(block_column * size - 1, 0);
  const int east = std::min(block_column * size + size - 1, surface.width - 1);
  const int north = std::max(block_row * size - 1, 0);
  const int south = std::min(block_row * size + size - 1, surface.height - 1);
  float highest = -std::numeric_limits<float>::infinity();
  for (int row = north; row <= south; ++row) {
    const auto line =
        surface.samples.subspan(static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.width));
    for (int column = west; column <= east; ++column) {
      highest = std::max(highest, line[static_cast<std::size_t>(column)]);
    }
  }
  return highest;
}

}  // namespace

BlockMaxima::BlockMaxima(const Surface& surface) {
  const int columns = surface.width / kSize + 1;  // of width + 1 patches, rounded up
  const int rows = surface.height / kSize + 1;
  columns_ = static_cast<std::size_t>(columns);
  maxima_.reserve(columns_ * static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      maxima_.push_back(highest_of_block(surface, column, row));
    }
  }
  highest_ = *std::max_element(maxima_.begin(), maxima_.end());
}

}  // namespace gnomon::oracle
