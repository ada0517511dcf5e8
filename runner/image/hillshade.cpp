// SPDX-License-Identifier: MIT
#include "image/hillshade.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace gnomon::image {
namespace {

using Colour = std::array<double, 3>;  ///< 0..1, display-referred

double mix(double a, double b, double t) {
  return a + t * (b - a);
}

Colour mix(const Colour& a, const Colour& b, double t) {
  return {mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)};
}

void put(Picture& picture, const Colour& colour) {
  for (const double part : colour)
    picture.rgb.push_back(static_cast<unsigned char>(std::lround(255.0 * std::clamp(part, 0.0, 1.0))));
}

/// Hypsometric tint: valley green over meadow and heath to rock and pale summits. `t` in [0, 1].
Colour tint(double t) {
  constexpr std::array<Colour, 6> kRamp{{{0.49, 0.60, 0.45},
                                         {0.66, 0.71, 0.50},
                                         {0.84, 0.79, 0.58},
                                         {0.80, 0.67, 0.49},
                                         {0.75, 0.65, 0.57},
                                         {0.96, 0.95, 0.93}}};
  const double position = std::clamp(t, 0.0, 1.0) * (kRamp.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(position), kRamp.size() - 2);
  return mix(kRamp[below], kRamp[below + 1], position - static_cast<double>(below));
}

/// Brightness of a slope relative to level ground, which keeps its own tint: from `lambert`, the cosine
/// between sun and normal relative to that of level ground. Bright slopes are held back so that they do not
/// burn out.
double in_sun(double lambert) {
  const double light = mix(0.35, 1.0, std::max(lambert, 0.0));
  return light < 1.0 ? light : 1.0 + 0.35 * (light - 1.0);
}

/// The same where only the sky shines: relief remains readable, softly.
double in_shadow(double lambert) {
  return mix(0.6, 0.9, std::clamp(lambert, 0.0, 1.0));
}

/// Linear light as a display expects it.
double encoded(double linear) {
  return std::pow(linear, 1.0 / 2.2);
}

/// Rise per metre towards the east and the north.
struct Slope {
  double east = 0;
  double north = 0;
};

/// Central differences, one-sided at the edges and beside a hole; 0 in a hole.
std::vector<Slope> slopes(const std::vector<float>& heights, int width, int height, double spacing_x,
                          double spacing_y) {
  const auto at = [&](int row, int column) -> double {
    return heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                   static_cast<std::size_t>(column)];
  };
  std::vector<Slope> slopes;
  slopes.reserve(heights.size());
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      if (std::isnan(at(row, column))) {
        slopes.push_back({});
        continue;
      }
      const int west = column > 0 && !std::isnan(at(row, column - 1)) ? column - 1 : column;
      const int east = column + 1 < width && !std::isnan(at(row, column + 1)) ? column + 1 : column;
      const int north = row > 0 && !std::isnan(at(row - 1, column)) ? row - 1 : row;
      const int south = row + 1 < height && !std::isnan(at(row + 1, column)) ? row + 1 : row;
      const double run_east = std::max(east - west, 1) * spacing_x;
      const double run_north = std::max(south - north, 1) * spacing_y;
      slopes.push_back(
          {(at(row, east) - at(row, west)) / run_east, (at(north, column) - at(south, column)) / run_north});
    }
  return slopes;
}

/// By how much slopes are exaggerated, so that the typical one is well visible; never flattened.
double exaggeration(const std::vector<Slope>& slopes) {
  double sum = 0;
  for (const Slope& slope : slopes) sum += slope.east * slope.east + slope.north * slope.north;
  const double typical = std::sqrt(sum / static_cast<double>(slopes.size()));
  return typical > 0 ? std::clamp(0.4 / typical, 1.0, 6.0) : 1.0;
}

}  // namespace

Picture hillshade(const std::vector<float>& heights, int width, int height, double spacing_x,
                  double spacing_y, const std::vector<float>& k_shadow, double sun_azimuth_deg,
                  double sun_elevation_deg) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  constexpr Colour kNoSurface{0.25, 0.26, 0.28};
  constexpr Colour kShadowTint{0.86, 0.95, 1.15};  // shadows are lit by the blue sky alone
  const double azimuth = sun_azimuth_deg * kDegree;
  const double elevation = std::clamp(sun_elevation_deg, 35.0, 90.0) * kDegree;
  const double sun_east = std::sin(azimuth) * std::cos(elevation);
  const double sun_north = std::cos(azimuth) * std::cos(elevation);
  const double sun_up = std::sin(elevation);

  const std::vector<Slope> relief = slopes(heights, width, height, spacing_x, spacing_y);
  const double steeper = exaggeration(relief);
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -lowest;
  for (const float height : heights) {
    if (std::isnan(height)) continue;
    lowest = std::min(lowest, double{height});
    highest = std::max(highest, double{height});
  }
  const double range = std::max(highest - lowest, 1e-30);

  Picture picture{width, height, {}};
  picture.rgb.reserve(3 * heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (std::isnan(heights[i])) {
      put(picture, kNoSurface);
      continue;
    }
    const double east = steeper * relief[i].east, north = steeper * relief[i].north;
    const double facing_sun =
        (sun_up - east * sun_east - north * sun_north) / std::sqrt(1 + east * east + north * north);
    const double lit = std::clamp(static_cast<double>(k_shadow[i]), 0.0, 1.0);
    const double light = mix(in_shadow(facing_sun / sun_up), in_sun(facing_sun / sun_up), lit) * encoded(lit);
    const Colour cast = mix(kShadowTint, {1, 1, 1}, lit);
    Colour colour = tint((heights[i] - lowest) / range);
    for (std::size_t c = 0; c < 3; ++c) colour[c] *= light * cast[c];
    put(picture, colour);
  }
  return picture;
}

}  // namespace gnomon::image
