// SPDX-License-Identifier: MIT
#include "technique/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/oracle.h"

namespace gnomon::technique {

glm::dvec3 to_sun(const scene::Sun& sun) {
  if (sun.elevation >= 90.0) return {0.0, 0.0, 1.0};
  const double elevation = sun.elevation * std::numbers::pi / 180.0;
  const oracle::GroundDirection ground = oracle::ground_direction(sun.azimuth);
  return {ground.east * std::cos(elevation), ground.north * std::cos(elevation), std::sin(elevation)};
}

glm::vec3 to_sun_single(const scene::Sun& sun) {
  constexpr float kSmallestHeight = 1e-30F;
  glm::vec3 direction(to_sun(sun));
  if (sun.elevation > 0) direction.z = std::max(direction.z, kSmallestHeight);
  return direction;
}

MapView map_view(const scene::MapCamera& camera, const terrain::HeightMap& map) {
  const glm::ivec2 size =
      camera.size ? glm::ivec2((*camera.size)[0], (*camera.size)[1]) : glm::ivec2(map.width, map.height);
  const glm::dvec2 ratio = glm::dvec2(map.width, map.height) / glm::dvec2(size);
  return {size, glm::vec2(ratio)};
}

}  // namespace gnomon::technique
