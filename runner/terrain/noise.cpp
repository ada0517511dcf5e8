// SPDX-License-Identifier: MIT
#include "terrain/noise.h"

#include <cmath>

namespace gnomon::terrain {
namespace {

struct Gradient {
  double x = 0;
  double y = 0;
};

/// A position along one axis: the lattice point before it, and how far beyond that it lies, in [0, 1).
struct LatticePosition {
  std::int64_t index = 0;
  double fraction = 0;
};

LatticePosition locate(double metres, double cell) {
  const double position = metres / cell;
  const double index = std::floor(position);
  return {static_cast<std::int64_t>(index), position - index};
}

/// The lattice columns that the samples of a row need, ascending, and where each sample finds its western
/// one. A fine lattice has far more columns than samples; only those that are read are hashed.
struct LatticeColumns {
  std::vector<std::int64_t> indices;
  struct Sample {
    std::size_t west = 0;  ///< position in `indices`; the eastern neighbour is the next one
    double fraction = 0;
  };
  std::vector<Sample> samples;
};

LatticeColumns lattice_columns(const Grid& grid, double cell) {
  LatticeColumns columns;
  std::int64_t west = -1;
  for (int column = 0; column < grid.width; ++column) {
    const LatticePosition x = locate(grid.x(column), cell);
    if (x.index != west) {
      const bool west_is_last = !columns.indices.empty() && columns.indices.back() == x.index;
      if (!west_is_last) columns.indices.push_back(x.index);
      columns.indices.push_back(x.index + 1);
      west = x.index;
    }
    columns.samples.push_back({columns.indices.size() - 2, x.fraction});
  }
  return columns;
}

/// A unit vector that is hashed from a lattice point: uniform in the square [-1, 1]^2, then normalised.
Gradient gradient_at(std::uint32_t seed, std::int64_t x, std::int64_t y) {
  const std::uint32_t first = hash(seed, x, y);
  const double gx = 2.0 * unit(first) - 1.0;
  const double gy = 2.0 * unit(hash(first)) - 1.0;
  const double length = std::sqrt(gx * gx + gy * gy);
  if (length == 0.0) return {1.0, 0.0};
  return {gx / length, gy / length};
}

std::vector<Gradient> gradient_row(std::uint32_t seed, const std::vector<std::int64_t>& columns,
                                   std::int64_t y) {
  std::vector<Gradient> row;
  row.reserve(columns.size());
  for (const std::int64_t x : columns) row.push_back(gradient_at(seed, x, y));
  return row;
}

double dot(const Gradient& gradient, double x, double y) {
  return gradient.x * x + gradient.y * y;
}

double fade(double t) {
  return t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
}

double interpolate(double a, double b, double t) {
  return a + t * (b - a);
}

/// sqrt(2): two-dimensional gradient noise with unit gradients reaches at most sqrt(1/2).
constexpr double kToUnitRange = 1.4142135623730951;

}  // namespace

Heights sample_noise(const Grid& grid, const Octave& octave) {
  const LatticeColumns columns = lattice_columns(grid, octave.cell);
  std::int64_t lattice_row = -1;
  std::vector<Gradient> north;
  std::vector<Gradient> south;
  Heights values;
  values.reserve(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height));
  for (int row = 0; row < grid.height; ++row) {
    const LatticePosition y = locate(grid.southward(row), octave.cell);
    if (y.index != lattice_row) {
      north = gradient_row(octave.seed, columns.indices, y.index);
      south = gradient_row(octave.seed, columns.indices, y.index + 1);
      lattice_row = y.index;
    }
    const double fade_y = fade(y.fraction);
    for (const auto& [west, x] : columns.samples) {
      const double nw = dot(north[west], x, y.fraction);
      const double ne = dot(north[west + 1], x - 1.0, y.fraction);
      const double sw = dot(south[west], x, y.fraction - 1.0);
      const double se = dot(south[west + 1], x - 1.0, y.fraction - 1.0);
      const double fade_x = fade(x);
      values.push_back(kToUnitRange *
                       interpolate(interpolate(nw, ne, fade_x), interpolate(sw, se, fade_x), fade_y));
    }
  }
  return values;
}

}  // namespace gnomon::terrain
