// SPDX-License-Identifier: MIT
// Stored numbers to heights, row by row. Internal to this folder.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "gnomon/diagnostic.h"
#include "terrain/height_map.h"

namespace gnomon::terrain {

/// metres = (stored * scale + offset) * unit.
struct Conversion {
  double scale = 1.0;
  double offset = 0.0;
  double unit = 1.0;
  std::optional<double> nodata{};  ///< a stored number that is no height
  bool single = false;             ///< numbers are stored as float32: `nodata` is meant in that precision
};

class HeightBuilder {
 public:
  HeightBuilder(std::string path, int width, int height, const Conversion& conversion);

  /// The next row, the northernmost first. `present` is 0 where the file itself says "no data"; empty:
  /// nowhere. NaN is no data too. Fails for an infinite height and one too high for single precision, naming
  /// its place.
  [[nodiscard]] std::optional<Diagnostic> add_row(std::span<const double> stored,
                                                  std::span<const unsigned char> present = {});

  /// After the last row; leaves the builder empty.
  [[nodiscard]] HeightMap take() { return std::move(map_); }

 private:
  [[nodiscard]] bool is_missing(double stored) const;

  std::string path_;
  Conversion conversion_;
  HeightMap map_;
};

}  // namespace gnomon::terrain
