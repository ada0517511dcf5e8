// SPDX-License-Identifier: MIT
#include "technique/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/oracle.h"
#include "technique/sun.h"
#include "technique/surface.h"
#include "terrain/level.h"

namespace gnomon::technique {
namespace {

/// The pixels whose shadow changes when the sun's azimuth does by a millionth of a radian: their ray passes
/// so close by a corner of a hole that single precision may see what lies beside it or not. Azimuths along
/// the axes have no such pixels, as their rays keep their column or row exactly.
std::vector<char> grazes_holes(const terrain::HeightMap& base, const oracle::Surface& surface,
                               const std::vector<oracle::Receiver>& receivers, const scene::Sun& sun,
                               const std::vector<double>& horizon) {
  std::vector<char> grazes(receivers.size(), 0);
  if (!base.holes || std::fmod(sun.azimuth, 90.0) == 0) return grazes;
  constexpr double kTurn = 1e-6 * 180.0 / std::numbers::pi;
  for (const double turn : {-kTurn, kTurn}) {
    const std::vector<double> turned =
        oracle::horizons(surface, receivers, oracle::ground_direction(sun.azimuth + turn));
    for (std::size_t i = 0; i < receivers.size(); ++i)
      if (oracle::in_shadow(turned[i], sun.elevation) != oracle::in_shadow(horizon[i], sun.elevation))
        grazes[i] = 1;
  }
  return grazes;
}

/// Eq. 1 of the 2022 paper for a pixel in shadow, in double.
double k_in_shadow(const scene::Shadow& shadow, double sun_height) {
  return shadow.k_dark + (shadow.k_bright - shadow.k_dark) * std::max(sun_height, 0.0);
}

/// Nothing is asked: lit, and no horizon ahead.
image::Image empty_image(const Ground& ground) {
  image::Image image = lit_image(ground);
  image.channels["band"].resize(image.pixels());
  image.channels["horizon"].assign(image.pixels(), static_cast<float>(-std::numbers::pi / 2));
  return image;
}

std::vector<oracle::Receiver> receivers_of(const Ground& ground, const std::vector<std::size_t>& pixels,
                                           int level, double height) {
  std::vector<oracle::Receiver> receivers;
  receivers.reserve(pixels.size());
  for (const std::size_t i : pixels) {
    receivers.push_back(
        {std::ldexp(double{ground.column[i]}, -level), std::ldexp(double{ground.row[i]}, -level), height});
  }
  return receivers;
}

/// Answers the pixels that ask for level q, from level `level`.
void answer(const scene::Scene& scene, const terrain::HeightMap& base, const Ground& ground, int q, int level,
            image::Image& image) {
  const terrain::HeightMap map = terrain::level(base, level);
  const oracle::Surface surface = surface_of(map);
  const std::vector<std::size_t> pixels = ground.asking(q);
  const std::vector<oracle::Receiver> receivers =
      receivers_of(ground, pixels, level, scene.shadow.receiver_height);
  const std::vector<double> horizons =
      oracle::horizons(surface, receivers, oracle::ground_direction(scene.sun.azimuth));
  const double band = oracle::band_width(level == 0 && ground.on_samples(), scene.shadow.receiver_height,
                                         oracle::steepest_slope(surface));
  const std::vector<char> grazes = grazes_holes(base, surface, receivers, scene.sun, horizons);
  const auto k_shadow = static_cast<float>(k_in_shadow(scene.shadow, to_sun(scene.sun).z));
  for (std::size_t i = 0; i < horizons.size(); ++i) {
    const std::size_t pixel = pixels[i];
    const bool shadow = oracle::in_shadow(horizons[i], scene.sun.elevation);
    const bool in_band = oracle::in_band(horizons[i], scene.sun.elevation, band) || grazes[i] != 0;
    image.channels["b_shadow"][pixel] = shadow ? 1.0F : 0.0F;
    image.channels["k_shadow"][pixel] = shadow ? k_shadow : 1.0F;
    image.channels["horizon"][pixel] = static_cast<float>(horizons[i]);
    image.channels["band"][pixel] = in_band ? 1.0F : 0.0F;
  }
}

/// The points of which the oracle itself says that there is a surface, on the map and on the level that
/// answers. Of a map camera's all are asked; what another camera does not see stays unseen.
Ground with_surface(const terrain::HeightMap& base, const Ground& points, std::optional<int> level) {
  Ground ground = points;
  if (ground.depth.empty()) ground.valid.assign(ground.pixels(), 1.0F);
  const oracle::Surface whole = surface_of(base);
  for (const int q : ground.levels()) {
    const int answering = level.value_or(q);
    const terrain::HeightMap map = terrain::level(base, answering);
    const oracle::Surface coarser = surface_of(map);
    for (std::size_t i = 0; i < ground.pixels(); ++i) {
      if (ground.valid[i] == 0 || static_cast<int>(ground.q[i]) != q) continue;
      const double column = double{ground.column[i]};
      const double row = double{ground.row[i]};
      const bool surface =
          oracle::has_surface(whole, column, row) &&
          oracle::has_surface(coarser, std::ldexp(column, -answering), std::ldexp(row, -answering));
      ground.valid[i] = surface ? 1.0F : 0.0F;
    }
  }
  return ground;
}

}  // namespace

image::Image reference_image(const scene::Scene& scene, const terrain::HeightMap& base, const Ground& points,
                             std::optional<int> level) {
  const Ground ground = base.holes ? with_surface(base, points, level) : points;
  image::Image image = empty_image(ground);
  for (const int q : ground.levels()) answer(scene, base, ground, q, level.value_or(q), image);
  return image;
}

}  // namespace gnomon::technique
