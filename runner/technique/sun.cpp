// SPDX-License-Identifier: MIT
#include "technique/sun.h"

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

}  // namespace gnomon::technique
