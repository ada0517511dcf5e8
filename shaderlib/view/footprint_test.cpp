// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(8, 8));

Modules::GnomonMap map_of(vec2 spacing) {
  Modules::GnomonMap map = kFlat.map();
  map.spacing = spacing;
  return map;
}

TEST(Footprint, FromStraightAboveIsThePixelItself) {
  const auto map = map_of(vec2(10, 5));
  EXPECT_EQ(kFlat.gnomon_footprint(map, vec3(0, 0, 1), vec3(0, 0, -1), vec3(20, 0, 0)), vec2(2, 0));
  EXPECT_EQ(kFlat.gnomon_footprint(map, vec3(0, 0, 1), vec3(0, 0, -3), vec3(0, -20, 0)), vec2(0, 4))
      << "rows run southward";
}

TEST(Footprint, StretchesAlongALowRay) {
  // 30 degrees above flat ground, looking east: a step across the ray, upward, is twice as long on the
  // ground.
  const vec3 direction(std::sqrt(0.75F), 0, -0.5F);
  const vec3 up(0.5F, 0, std::sqrt(0.75F));
  const vec2 far = kFlat.gnomon_footprint(map_of(vec2(1)), vec3(0, 0, 1), direction, up);
  EXPECT_NEAR(far.x, 2, 1e-5);
  EXPECT_NEAR(far.y, 0, 1e-5);
}

TEST(Footprint, IsTheDifferenceOfTwoHits) {
  const vec3 normal = normalize(vec3(-0.3F, 0.2F, 1));
  const vec3 eye(3, -200, 300);
  const vec3 direction(0.05F, 0.7F, -0.9F);
  const vec3 right(0.01F, 0.002F, 0.001F);
  const auto hit = [&](vec3 along) { return eye - along * (dot(normal, eye) / dot(normal, along)); };
  const float t = -dot(normal, eye) / dot(normal, direction);
  const vec3 difference = (hit(direction + right * 1e-2F) - hit(direction - right * 1e-2F)) * 50.0F;
  const vec2 texels = kFlat.gnomon_footprint(map_of(vec2(2, 4)), normal, direction, right * t);
  EXPECT_NEAR(texels.x, difference.x / 2, 2e-2);
  EXPECT_NEAR(texels.y, -difference.y / 4, 2e-2);
}

}  // namespace
}  // namespace gnomon::modules
