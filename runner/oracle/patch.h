// SPDX-License-Identifier: MIT
// One bilinear patch, and the ground track across it along one axis. Private to the oracle.
//
// Coordinates are in samples: sample j of an axis lies at j, which is 0.5 less than its texel coordinate.
// Patch p spans p - 1 .. p, so an axis of n samples has the patches 0 .. n; its first and last patch, whose
// outer sample is the clamped edge, reach beyond the domain.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "oracle/oracle.h"

namespace gnomon::oracle {

/// The ground track seen along one axis (columns eastward or rows southward) of the surface.
struct Axis {
  double origin = 0;       ///< the receiver, samples
  double rate = 0;         ///< samples per metre of ground distance, signed
  double domain_exit = 0;  ///< ground distance at which the track leaves the domain, metres

  Axis(double texel, double domain, double samples_per_metre) : origin(texel - 0.5), rate(samples_per_metre) {
    domain_exit = distance(rate > 0 ? domain - texel : -texel);
  }

  /// The patch of the receiver. On an edge it is the one in front or, its crossing being of length 0, the one
  /// behind.
  [[nodiscard]] int first_patch() const { return static_cast<int>(std::floor(origin)) + 1; }

  /// Where the track is after `ground_distance` metres, samples.
  [[nodiscard]] double position(double ground_distance) const { return origin + ground_distance * rate; }

  /// Ground distance at which the track leaves the patches first .. last; infinite if it runs along them.
  [[nodiscard]] double exit(int first, int last) const {
    return distance((rate > 0 ? last : first - 1) - origin);
  }

 private:
  [[nodiscard]] double distance(double samples) const {
    return rate != 0 ? samples / rate : std::numeric_limits<double>::infinity();
  }
};

/// h(s) = h(0) + linear * s + quadratic * s^2 along the ground track, s in metres.
struct Profile {
  double linear = 0;
  double quadratic = 0;
};

/// The four corner heights of a patch, metres above a datum.
struct Patch {
  double north_west, north_east, south_west, south_east;

  Patch(const Surface& surface, int column, int row, double datum) {
    const int west = std::max(column - 1, 0);
    const int east = std::min(column, surface.width - 1);
    const auto height = [&](int sample_row, int sample_column) {
      const auto index = static_cast<std::size_t>(sample_row) * static_cast<std::size_t>(surface.width) +
                         static_cast<std::size_t>(sample_column);
      return static_cast<double>(surface.samples[index]) - datum;
    };
    const int north = std::max(row - 1, 0);
    const int south = std::min(row, surface.height - 1);
    north_west = height(north, west);
    north_east = height(north, east);
    south_west = height(south, west);
    south_east = height(south, east);
  }

  /// Whether all four corners hold data. Heights and datum are so small against kNoData that any datum will
  /// do.
  [[nodiscard]] bool is_whole() const {
    return std::min(std::min(north_west, north_east), std::min(south_west, south_east)) > Surface::kNoData;
  }

  /// Height at the fractions x (eastward) and y (southward) of the patch.
  [[nodiscard]] double height(double x, double y) const {
    return north_west + x * (north_east - north_west) + y * (south_west - north_west) + x * y * twist();
  }

  /// The surface along a track that passes the fractions x, y at the given rates (patches per metre).
  [[nodiscard]] Profile profile(double x, double y, double rate_x, double rate_y) const {
    const double slope_x = (north_east - north_west) + y * twist();
    const double slope_y = (south_west - north_west) + x * twist();
    return {rate_x * slope_x + rate_y * slope_y, rate_x * rate_y * twist()};
  }

 private:
  [[nodiscard]] double twist() const { return (north_west - north_east) + (south_east - south_west); }
};

/// A patch by its indices.
struct PatchIndex {
  int column = 0;
  int row = 0;
};

/// Whether the patch has a surface.
inline bool is_whole(const Surface& surface, PatchIndex patch) {
  return Patch(surface, patch.column, patch.row, 0.0).is_whole();
}

/// A patch with a surface that holds the place x, y (in samples), its edges included: the one in the
/// south-east first.
inline std::optional<PatchIndex> ground_patch(const Surface& surface, double x, double y) {
  const auto first = [](double at) { return static_cast<int>(std::floor(at)) + 1; };
  const int columns = x == std::floor(x) ? 2 : 1;
  const int rows = y == std::floor(y) ? 2 : 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const PatchIndex patch{first(x) - j, first(y) - i};
      if (is_whole(surface, patch)) return patch;
    }
  return std::nullopt;
}

}  // namespace gnomon::oracle
