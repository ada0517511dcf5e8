// SPDX-License-Identifier: MIT
#include "technique/reference.h"

#include <algorithm>
#include <cmath>

#include "oracle/oracle.h"
#include "technique/surface.h"
#include "technique/view.h"
#include "terrain/level.h"

namespace gnomon::technique {
namespace {

std::vector<oracle::Receiver> receivers_of(const MapView& view, int level, double height) {
  std::vector<oracle::Receiver> receivers;
  receivers.reserve(static_cast<std::size_t>(view.size.x) * static_cast<std::size_t>(view.size.y));
  for (int y = 0; y < view.size.y; ++y) {
    for (int x = 0; x < view.size.x; ++x) {
      receivers.push_back(
          {std::ldexp(double{view.column(x)}, -level), std::ldexp(double{view.row(y)}, -level), height});
    }
  }
  return receivers;
}

/// Eq. 1 of the 2022 paper for a pixel in shadow, in double.
double k_in_shadow(const scene::Shadow& shadow, double sun_height) {
  return shadow.k_dark + (shadow.k_bright - shadow.k_dark) * std::max(sun_height, 0.0);
}

}  // namespace

image::Image reference_image(const scene::Scene& scene, const terrain::HeightMap& base, int level) {
  const terrain::HeightMap map = terrain::level(base, level);
  const oracle::Surface surface = surface_of(map);
  const MapView view = map_view(scene.camera, base);
  const std::vector<double> horizon =
      oracle::horizons(surface, receivers_of(view, level, scene.shadow.receiver_height),
                       oracle::ground_direction(scene.sun.azimuth));
  const double band = oracle::band_width(level == 0 && view.on_samples(), scene.shadow.receiver_height,
                                         oracle::steepest_slope(surface));
  const auto k_shadow = static_cast<float>(k_in_shadow(scene.shadow, to_sun(scene.sun).z));

  image::Image image{.width = view.size.x, .height = view.size.y, .channels = {}, .attributes = {}};
  for (const char* name : {"b_shadow", "k_shadow", "horizon", "band"})
    image.channels[name].reserve(horizon.size());
  for (const double angle : horizon) {
    const bool shadow = oracle::in_shadow(angle, scene.sun.elevation);
    image.channels["b_shadow"].push_back(shadow ? 1.0F : 0.0F);
    image.channels["k_shadow"].push_back(shadow ? k_shadow : 1.0F);
    image.channels["horizon"].push_back(static_cast<float>(angle));
    image.channels["band"].push_back(oracle::in_band(angle, scene.sun.elevation, band) ? 1.0F : 0.0F);
  }
  image.channels["q"].assign(horizon.size(), static_cast<float>(level));
  image.channels["steps"].assign(horizon.size(), 0.0F);
  image.channels["valid"].assign(horizon.size(), 1.0F);
  return image;
}

}  // namespace gnomon::technique
