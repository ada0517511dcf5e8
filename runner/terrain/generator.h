// SPDX-License-Identifier: MIT
// What the makers of procedural maps share. Internal to this folder; scenes go through procedural.h.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gnomon::terrain {

/// The grid that a generator fills: row 0 = north, column 0 = west.
struct Grid {
  int width = 0;
  int height = 0;
  double spacing_x = 1.0;  ///< metres
  double spacing_y = 1.0;  ///< metres
  std::uint32_t seed = 0;

  /// Metres from the west edge of the domain to the samples of a column.
  [[nodiscard]] double x(int column) const { return (column + 0.5) * spacing_x; }
  /// Metres from the north edge of the domain to the samples of a row.
  [[nodiscard]] double southward(int row) const { return (row + 0.5) * spacing_y; }
  [[nodiscard]] double width_metres() const { return width * spacing_x; }
  [[nodiscard]] double height_metres() const { return height * spacing_y; }
};

/// Every parameter of the kind, defaults filled in, each within its range.
using Parameters = std::map<std::string, double>;

/// Metres, row-major, one for each sample of the grid.
using Heights = std::vector<double>;

using Generator = Heights (*)(const Grid& grid, const Parameters& parameters);

/// The heights that `height_at(row, column)` gives.
template <class HeightAt>
Heights fill(const Grid& grid, HeightAt height_at) {
  Heights heights;
  heights.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column) heights.push_back(height_at(row, column));
  return heights;
}

// shapes.cpp: surfaces whose shadows have a closed form, and stress maps.
Heights flat(const Grid& grid, const Parameters& parameters);
Heights plane(const Grid& grid, const Parameters& parameters);
Heights wall(const Grid& grid, const Parameters& parameters);
Heights step(const Grid& grid, const Parameters& parameters);
Heights steps(const Grid& grid, const Parameters& parameters);
Heights cone(const Grid& grid, const Parameters& parameters);
Heights spikes(const Grid& grid, const Parameters& parameters);
Heights posts(const Grid& grid, const Parameters& parameters);
Heights crater(const Grid& grid, const Parameters& parameters);
Heights checker(const Grid& grid, const Parameters& parameters);

// fractal.cpp, gorge.cpp: landscapes.
Heights fractal(const Grid& grid, const Parameters& parameters);
Heights gorge(const Grid& grid, const Parameters& parameters);

}  // namespace gnomon::terrain
