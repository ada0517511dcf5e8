// SPDX-License-Identifier: MIT
// The double-precision oracle: the exact horizon of a point on a bilinear height field towards an azimuth.
// Independent of every shader; the standard library only. docs/algorithms.md, "The oracle".
#pragma once

#include <limits>
#include <span>
#include <vector>

namespace gnomon::oracle {

/// A view of one level of a height map. Sample (row i, column j) lies at column j + 0.5, row i + 0.5 (texels
/// from the west and north edge); bilinear in between, clamped to the edge, over 0..domain_width x
/// 0..domain_height texels.
struct Surface {
  /// A sample at or below this holds no data. A patch with such a corner has no surface: it neither hides
  /// anything nor is there anything on it. Patches are closed: an edge belongs to every patch beside it.
  static constexpr float kNoData = -1e20F;

  int width = 0;
  int height = 0;
  double spacing_x = 1.0;          ///< metres per texel
  double spacing_y = 1.0;          ///< metres per texel
  double domain_width = 0;         ///< texels; at most `width`
  double domain_height = 0;        ///< texels; at most `height`
  std::span<const float> samples;  ///< row-major, row 0 = north, metres
};

/// Where the question is asked: texels of this Surface, and metres above it (0: exactly on the surface).
struct Receiver {
  double column = 0;
  double row = 0;
  double height = 0;
};

/// Unit ground direction towards the sun: x east, y north.
struct GroundDirection {
  double east = 0;
  double north = 1;
};

/// The direction of a compass azimuth in degrees clockwise from north; exact for multiples of 45 degrees.
[[nodiscard]] GroundDirection ground_direction(double azimuth_degrees);

/// Whether there is a surface at (column, row).
[[nodiscard]] bool has_surface(const Surface& surface, double column, double row);

/// Height of the surface at (column, row), metres; meaningless where there is none.
[[nodiscard]] double surface_height(const Surface& surface, double column, double row);

/// H* = sup over d > 0 of (h(d) - h0) / d (d in metres along the ground towards the sun, within the domain,
/// h0 the receiver's own height); -infinity where no surface lies ahead, or none under the receiver, or it is
/// outside the domain, +infinity from under the ground. A corner that the track only touches, its other
/// patches there having no surface, does not count.
[[nodiscard]] double horizon_slope(const Surface& surface, const Receiver& receiver,
                                   GroundDirection towards_sun);

/// atan(H*) in radians for many receivers at once, -pi/2 where nothing lies ahead. `threads` <= 0: one per
/// core.
[[nodiscard]] std::vector<double> horizons(const Surface& surface, std::span<const Receiver> receivers,
                                           GroundDirection towards_sun, int threads = 0);

/// The definition of shadow: elevation <= 0: always; zenith (>= 90 degrees): never; else horizon strictly
/// above.
[[nodiscard]] bool in_shadow(double horizon_radians, double elevation_degrees);

/// Half-width in radians of the band around the horizon in which single precision may decide either way: 1e-5
/// for receivers on a sample of the base map, on the ground, where no slope between neighbouring samples
/// exceeds 50; else 1e-4.
[[nodiscard]] double band_width(bool on_samples_of_base_map, double receiver_height, double steepest_slope);

/// Whether |horizon - elevation| is within the band; never for elevation <= 0 and at the zenith.
[[nodiscard]] bool in_band(double horizon_radians, double elevation_degrees, double band_width_radians);

/// Largest |height difference| / distance between samples with data that are neighbours along a row or a
/// column.
[[nodiscard]] double steepest_slope(const Surface& surface);

}  // namespace gnomon::oracle
