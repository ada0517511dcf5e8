// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "testing/cpp_modules.h"

namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec3;

TEST(Receiver, PatchAndFractionGiveTheCoordinateBack) {
  for (int i = 0; i < 4000; ++i) {
    const float column = static_cast<float>(i) * 4.0917F;
    float fraction = -1;
    const int patch = glsl::gnomon_patch_of(column, fraction);
    EXPECT_GE(fraction, 0.0F);
    EXPECT_LE(fraction, 1.0F);
    EXPECT_EQ(double{column}, patch - 0.5 + double{fraction}) << "column " << column;
  }
}

TEST(Receiver, SampleIsTheNorthWestCornerOfItsOwnPatch) {
  const glsl::GnomonReceiver receiver = glsl::gnomon_receiver_at(7.5F, 2.5F, 3.0F);
  EXPECT_EQ(receiver.patch_index, ivec2(8, 3));
  EXPECT_EQ(receiver.fraction, vec2(0, 0));
  EXPECT_EQ(receiver.height, 3.0F);
}

TEST(SunWithoutRay, BelowOrAtThePlaneIsShadowAndZenithIsLit) {
  EXPECT_EQ(glsl::gnomon_shadow_without_ray(vec3(1, 0, 0)).shadow, 1.0F);
  EXPECT_EQ(glsl::gnomon_shadow_without_ray(vec3(0.6F, 0, -0.8F)).cause, GNOMON_CAUSE_SUN_BELOW);
  EXPECT_EQ(glsl::gnomon_shadow_without_ray(vec3(0, 0, 1)).cause, GNOMON_CAUSE_ZENITH);
  EXPECT_EQ(glsl::gnomon_shadow_without_ray(vec3(0, 0, 1)).shadow, 0.0F);
  EXPECT_EQ(glsl::gnomon_shadow_without_ray(vec3(0.6F, 0, 0.8F)).cause, GNOMON_CAUSE_UNDECIDED);
}

TEST(Shade, DarkAtTheHorizonBrightAtTheZenithAndOneWhereLit) {
  EXPECT_EQ(glsl::gnomon_k_shadow(1, 0, 0.2F, 0.6F), 0.2F);
  EXPECT_EQ(glsl::gnomon_k_shadow(1, 1, 0.2F, 0.6F), 0.2F + (0.6F - 0.2F));
  EXPECT_EQ(glsl::gnomon_k_shadow(0, 0.3F, 0.2F, 0.6F), 1.0F);
}

TEST(Shade, NeverDarkerThanDarkUnderTheHorizon) {
  EXPECT_EQ(glsl::gnomon_k_shadow(1, -1, 0.2F, 0.6F), 0.2F);
}

TEST(Shade, IsDefinedForBlackShadow) {
  EXPECT_EQ(glsl::gnomon_k_shadow(0, 0, 0, 0), 1.0F);
}

gnomon::terrain::HeightMap flat(int width, int height) {
  return {width,
          height,
          1,
          1,
          double(width),
          double(height),
          std::vector<float>(std::size_t(width * height), 5.0F)};
}

TEST(Ray, StepsToEveryPatchUnderItWithoutTurningBack) {
  const auto map = flat(40, 30);
  const glsl::GnomonMap glsl_map = glsl::use_map(map);
  for (int i = 0; i < 720; ++i) {
    const float azimuth = static_cast<float>(i) * 0.5F * 0.0174532925F;
    const vec3 sun(0.9F * std::sin(azimuth), 0.9F * std::cos(azimuth), 0.436F);
    const glsl::GnomonReceiver receiver = glsl::gnomon_receiver_at(17.3F, 11.9F, 0);
    const glsl::GnomonRay ray = glsl::gnomon_ray(glsl_map, receiver, sun, 0);
    ivec2 patch = ray.start;
    float t = 0;
    int steps = 0;
    for (; t < ray.t_end && steps < 200; ++steps) {
      const vec2 exits = glsl::gnomon_ray_exits(ray, patch, 0);
      const ivec2 next = glsl::gnomon_ray_next(ray, patch, patch, 0, exits);
      const ivec2 moved = glm::abs(next - patch);
      EXPECT_TRUE(moved.x <= 1 && moved.y <= 1 && moved.x + moved.y >= 1);
      EXPECT_GE(std::min(exits.x, exits.y), t - 1e-5F);
      patch = next;
      t = std::min(exits.x, exits.y);
    }
    EXPECT_LT(steps, 80) << "azimuth " << i * 0.5;
  }
}

TEST(Crossing, ParabolaTopInsideAPatchIsSeen) {
  const glsl::GnomonCrossing hill{.slope = 2.0F, .curvature = -2.0F, .above = 0};
  EXPECT_TRUE(glsl::gnomon_crossing_hides(hill, -0.499F, 1.0F));
  EXPECT_FALSE(glsl::gnomon_crossing_hides(hill, -0.501F, 1.0F));
  EXPECT_FALSE(glsl::gnomon_crossing_hides(hill, -0.499F, 0.4F)) << "the top lies beyond this length";
}

TEST(Crossing, GrazingIsNotShadow) {
  EXPECT_FALSE(glsl::gnomon_crossing_hides({.slope = 0, .curvature = 0, .above = 0}, 0, 1));
  EXPECT_TRUE(glsl::gnomon_crossing_hides({.slope = 1e-20F, .curvature = 0, .above = 0}, 0, 1));
}

}  // namespace
