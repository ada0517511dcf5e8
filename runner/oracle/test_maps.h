// SPDX-License-Identifier: MIT
// Height fields for the oracle's tests, and a second, naive reading of the bilinear surface to hold it
// against.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <utility>
#include <vector>

#include "oracle/oracle.h"

namespace gnomon::oracle::test {

/// Samples together with the Surface that looks at them.
struct Map {
  int width = 0;
  int height = 0;
  std::vector<float> samples;
  double spacing_x = 1;
  double spacing_y = 1;

  [[nodiscard]] Surface surface() const {
    return {width, height, spacing_x, spacing_y, double(width), double(height), samples};
  }
  [[nodiscard]] float at(int row, int column) const {
    return samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
  }
};

/// The map whose sample (row, column) is height(row, column).
inline Map make_map(int width, int height, const std::function<double(int row, int column)>& height_at) {
  Map map{width, height, {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column)
      map.samples.push_back(static_cast<float>(height_at(row, column)));
  }
  return map;
}

/// A receiver on the ground at sample (row, column).
inline Receiver on_sample(int row, int column) {
  return {column + 0.5, row + 0.5, 0};
}

using Random = std::mt19937_64;  // its sequence is the same on every platform; the distributions' are not

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
}

inline int uniform_int(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::size_t>(high - low + 1));
}

/// Independent heights 0 .. relief at every sample: every patch is a steep saddle.
inline Map noise_map(Random& random, int width, int height, double relief) {
  return make_map(width, height, [&](int, int) { return uniform(random, 0, relief); });
}

/// Flat ground with single-sample spikes and pits, far above sea level.
inline Map spike_map(Random& random, int width, int height) {
  return make_map(width, height, [&](int, int) {
    const double dice = uniform(random, 0, 1);
    return 4000 + (dice < 0.03 ? 500 : dice < 0.05 ? -300 : 0);
  });
}

/// Rolling hills that meet the patch edges nearly without a kink.
inline Map smooth_map(Random& random, int width, int height) {
  const double a = uniform(random, 0.1, 0.4), b = uniform(random, 0.1, 0.4), phase = uniform(random, 0, 6);
  return make_map(width, height, [&](int row, int column) {
    return 10 * std::sin(a * column + phase) * std::cos(b * row) + 3 * std::sin(0.7 * (column - row));
  });
}

/// Whole metres 0 .. 8: sums, differences and doublings of the samples are exact.
inline Map whole_metre_map(Random& random, int width, int height) {
  return make_map(width, height, [&](int, int) { return uniform_int(random, 0, 8); });
}

/// A receiver on a sample, on a patch edge, on a dyadic point between, or anywhere; on the ground or above
/// it.
inline Receiver random_receiver(Random& random, const Map& map, double height) {
  const auto along = [&](int samples, int kind) {
    const int sample = uniform_int(random, 0, samples - 1);
    if (kind == 0) return sample + 0.5;
    if (kind == 1) return sample + uniform_int(random, 0, 16) / 16.0;
    return uniform(random, 0, samples);
  };
  const int kind = uniform_int(random, 0, 3);
  return {along(map.width, kind == 3 ? 1 : kind), along(map.height, kind == 3 ? 0 : kind), height};
}

/// Axes, diagonals and everything between, in equal parts.
inline double random_azimuth(Random& random) {
  const int kind = uniform_int(random, 0, 2);
  return kind == 0   ? 90.0 * uniform_int(random, 0, 3)
         : kind == 1 ? 45.0 + 90.0 * uniform_int(random, 0, 3)
                     : uniform(random, 0, 360);
}

/// The surface by its definition: weights of the four nearest samples, clamped to the edge.
inline long double naive_height(const Map& map, long double column, long double row) {
  const long double west = std::floor(column - 0.5L), north = std::floor(row - 0.5L);
  const long double x = column - 0.5L - west, y = row - 0.5L - north;
  const auto sample = [&](long double sample_row, long double sample_column) -> long double {
    return map.at(std::clamp(static_cast<int>(sample_row), 0, map.height - 1),
                  std::clamp(static_cast<int>(sample_column), 0, map.width - 1));
  };
  return (1 - y) * ((1 - x) * sample(north, west) + x * sample(north, west + 1)) +
         y * ((1 - x) * sample(north + 1, west) + x * sample(north + 1, west + 1));
}

}  // namespace gnomon::oracle::test
