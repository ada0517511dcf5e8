// SPDX-License-Identifier: MIT
#include "testing/random_arguments.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::modules {

float RandomArguments::between(float low, float high) {
  return std::uniform_real_distribution<float>(low, high)(engine_);
}

float RandomArguments::power_of_ten(float low, float high) {
  const float value = std::pow(10.0F, between(low, high));
  return chance(0.5F) ? -value : value;
}

int RandomArguments::whole(int low, int high) {
  return std::uniform_int_distribution<int>(low, high)(engine_);
}

float RandomArguments::coordinate(float extent) {
  const float anywhere = between(0, extent);
  switch (whole(0, 5)) {
    case 0:
      return std::floor(anywhere);
    case 1:
      return std::floor(anywhere) + 0.5F;
    case 2:
      return std::nextafter(std::floor(anywhere) + 0.5F, chance(0.5F) ? 0.0F : extent);
    case 3:
      return chance(0.9F) ? anywhere : (chance(0.5F) ? 0.0F : extent);
    default:
      return anywhere;
  }
}

float RandomArguments::fraction() {
  if (chance(0.1F)) return 0;
  if (chance(0.1F)) return 1;
  return chance(0.1F) ? std::abs(power_of_ten(-8, -1)) : between(0, 1);
}

float RandomArguments::height_above_ground() {
  return chance(0.5F) ? 0.0F : std::abs(power_of_ten(-4, 3));
}

ivec2 RandomArguments::patch_index() {
  return {whole(0, modules_.heights().width), whole(0, modules_.heights().height)};
}

Modules::GnomonMap RandomArguments::map() {
  Modules::GnomonMap map = modules_.map();
  if (chance(0.7F)) map.spacing = vec2(std::abs(power_of_ten(-1, 3)));
  if (chance(0.3F)) map.spacing.y = std::abs(power_of_ten(-1, 3));
  return map;
}

Modules::GnomonReceiver RandomArguments::receiver() {
  const vec2 domain = modules_.map().domain;
  const float column = coordinate(domain.x);
  return modules_.gnomon_receiver_at(column, coordinate(domain.y), height_above_ground());
}

vec3 RandomArguments::sun() {
  const float azimuth = chance(0.3F) ? 45.0F * static_cast<float>(whole(0, 7)) : between(0, 360);
  const double angle = azimuth * std::numbers::pi / 180;
  const double elevation = std::atan(std::abs(power_of_ten(-4, 2)));
  vec3 sun(std::sin(angle) * std::cos(elevation), std::cos(angle) * std::cos(elevation), std::sin(elevation));
  // Exactly along the axes, where sin(pi) is not 0.
  if (std::abs(sun.x) < 1e-9F) sun.x = 0;
  if (std::abs(sun.y) < 1e-9F) sun.y = 0;
  return sun;
}

vec3 RandomArguments::any_sun() {
  vec3 sun = this->sun();
  if (chance(0.1F)) sun.z = -sun.z;
  if (chance(0.05F)) sun.z = 0;
  if (chance(0.05F)) sun = vec3(0, 0, chance(0.5F) ? 1 : -1);
  return sun;
}

Modules::GnomonRay RandomArguments::ray() {
  return modules_.gnomon_ray(map(), receiver(), sun(), 0);
}

Modules::GnomonPatch RandomArguments::patch() {
  if (chance(0.7F)) return modules_.gnomon_patch(patch_index(), between(-100, 3000), 0);
  return {.origin = power_of_ten(-10, 6),
          .slope = vec2(power_of_ten(-10, 6), power_of_ten(-10, 6)),
          .twist = power_of_ten(-10, 6)};
}

Modules::GnomonCrossing RandomArguments::crossing() {
  if (chance(0.7F)) {
    const Place at = place(0);
    return modules_.gnomon_crossing(at.ray, at.cursor.patch_index, at.cursor.t, 0);
  }
  return {.slope = power_of_ten(-10, 6), .curvature = power_of_ten(-10, 6), .above = power_of_ten(-4, 4)};
}

float RandomArguments::clearance(const Modules::GnomonCrossing& crossing, float crossed) {
  if (chance(0.2F)) return 0;
  if (chance(0.2F)) return std::min(0.0F, -crossed * (crossing.slope + crossing.curvature * crossed));
  if (chance(0.2F) && crossing.curvature < 0)
    return crossing.slope * crossing.slope / (4.0F * crossing.curvature);
  return -std::abs(power_of_ten(-6, 4));
}

vec3 RandomArguments::sun_at_horizon(const Modules::GnomonMap& map, const Modules::GnomonReceiver& receiver) {
  vec3 shadow = sun();
  vec3 lit = shadow;
  shadow.z = 0;
  lit.z = 1e4F;
  for (int i = 0; i < 100; ++i) {
    const vec3 middle(lit.x, lit.y, 0.5F * (shadow.z + lit.z));
    if (middle.z == shadow.z || middle.z == lit.z) break;
    const auto answer = modules_.gnomon_multilevel(map, receiver, middle, 0, modules_.step_limit());
    (answer.shadow > 0 ? shadow : lit) = middle;
  }
  return chance(0.5F) ? shadow : lit;
}

RandomArguments::View RandomArguments::view(const Modules::GnomonMap& map) {
  const vec3 extent(map.domain * map.spacing, map.highest);
  const auto near_map = [&] {
    return extent * vec3(between(0, 1), between(0, 1), chance(0.9F) ? between(0, 1.5F) : between(-1, 0));
  };
  const vec3 origin = near_map() + extent.x * vec3(between(-1, 1), between(-1, 1), between(0, 1));
  if (chance(0.05F)) return {origin, vec3(0, 0, chance(0.8F) ? -1 : 1)};
  const vec3 direction = near_map() - origin;
  return {origin, chance(0.5F) ? normalize(direction) : direction};
}

RandomArguments::Place RandomArguments::place(int top_level) {
  Place at{.ray = ray(), .cursor = {}, .low = {}, .level = whole(0, top_level), .exits = {}};
  const float t = chance(0.2F) ? 0.0F : between(0, at.ray.t_end);
  ivec2 patch = at.ray.start + ivec2(floor(at.ray.fraction + at.ray.direction * t));
  patch = clamp(patch, ivec2(0), modules_.map().size);
  at.cursor = {.patch_index = patch, .t = t, .steps = whole(0, 5000), .cause = 0};
  at.low = (patch >> at.level) << at.level;
  at.exits = modules_.gnomon_ray_exits(at.ray, at.low, at.level);
  return at;
}

}  // namespace gnomon::modules
