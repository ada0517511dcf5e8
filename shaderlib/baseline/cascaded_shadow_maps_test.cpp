// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

using M = Modules;

const float kDiagonal = std::sqrt(0.5F);
const vec3 kToSun(kDiagonal, 0, kDiagonal);  // in the east, 45 degrees high

/// The sun's view of a flat map of 16 x 16 samples at height 0: its right is south, its down is downhill.
M::GnomonLight light() {
  M::GnomonLight light{};
  light.origin = vec3(8, 8, 0) + kToSun * 50.0F;
  light.right = vec3(0, -1, 0);
  light.down = vec3(kDiagonal, 0, -kDiagonal);
  light.range = 100;
  light.size = 64;
  light.cascades = 2;
  light.grid_step = 1;
  light.bias = 0.5F;
  light.filter_width = 1;
  light.cascade[0] = {.corner = vec2(-4), .texel = 0.125F};
  light.cascade[1] = {.corner = vec2(-16), .texel = 0.5F};
  return light;
}

/// Whether the middle of the map is in shadow where the sun sees something this near everywhere.
float share_at(vec2 at, float nearness, const M::GnomonLight& taken = light()) {
  MapModules modules(flat_map(16, 16, 0));
  modules.light_nearness = [nearness](ivec2, int) { return nearness; };
  const auto receiver = modules.gnomon_receiver_at(at.x, at.y, 0);
  return modules.gnomon_cascaded_shadow_maps(modules.map(), receiver, kToSun, 0, taken).shadow;
}

TEST(CascadedShadowMaps, ShadowsWhatLiesBehindWhatTheSunSees) {
  EXPECT_EQ(share_at({8, 8}, 0.0F), 0.0F) << "the sun sees nothing";
  EXPECT_EQ(share_at({8, 8}, 0.5F), 0.0F) << "the sun sees the ground itself";
  EXPECT_EQ(share_at({8, 8}, 0.49F), 0.0F) << "something 1 m behind it";
  EXPECT_EQ(share_at({8, 8}, 0.51F), 1.0F) << "something 1 m before it";
}

TEST(CascadedShadowMaps, LightsWhatNoCascadeHolds) {
  M::GnomonLight only_fine = light();
  only_fine.cascades = 1;
  EXPECT_EQ(share_at({8, 15}, 1.0F), 1.0F) << "7 m south: the coarse one";
  EXPECT_EQ(share_at({8, 15}, 1.0F, only_fine), 0.0F);
}

TEST(CascadedShadowMaps, ShadowsTrianglesThatFaceAway) {
  terrain::HeightMap map = flat_map(8, 8, 0);
  for (std::size_t i = 0; i < map.samples.size(); ++i) map.samples[i] = 2.0F * static_cast<float>(i % 8);
  const MapModules modules(map);  // rises eastward by more than the sun's 45 degrees
  const auto receiver = modules.gnomon_receiver_at(4, 4, 0);
  EXPECT_EQ(modules.gnomon_cascaded_shadow_maps(modules.map(), receiver, kToSun, 0, light()).shadow, 1.0F);
}

TEST(CascadedShadowMaps, NeedsNoMapForASunBelowThePlaneOrAtTheZenith) {
  const MapModules modules(flat_map(4, 4));
  const auto receiver = modules.gnomon_receiver_at(2, 2, 0);
  const auto below = modules.gnomon_cascaded_shadow_maps(modules.map(), receiver, vec3(1, 0, 0), 0, light());
  EXPECT_EQ(below.cause, GNOMON_CAUSE_SUN_BELOW);
  const auto zenith = modules.gnomon_cascaded_shadow_maps(modules.map(), receiver, vec3(0, 0, 1), 0, light());
  EXPECT_EQ(zenith.cause, GNOMON_CAUSE_ZENITH);
}

TEST(CascadeTexel, CountsFromTheCorner) {
  const MapModules modules(flat_map(2, 2));
  EXPECT_EQ(modules.gnomon_cascade_texel({.corner = vec2(-4, 2), .texel = 0.5F}, vec2(-3, 4)), vec2(2, 4));
}

TEST(CascadeOf, IsTheFinestThatHoldsTheFilterToo) {
  const MapModules modules(flat_map(2, 2));
  M::GnomonLight wide = light();
  EXPECT_EQ(modules.gnomon_cascade_of(wide, vec2(0)), 0);
  EXPECT_EQ(modules.gnomon_cascade_of(wide, vec2(3.9F, 0)), 0);
  wide.filter_width = 7;
  EXPECT_EQ(modules.gnomon_cascade_of(wide, vec2(3.9F, 0)), 1) << "0.1 m are less than 3.5 texels";
  EXPECT_EQ(modules.gnomon_cascade_of(wide, vec2(0, -12)), 1);
  EXPECT_EQ(modules.gnomon_cascade_of(wide, vec2(0, -17)), 2) << "none";
}

TEST(CascadeBias, GrowsWithTexelFilterAndSlope) {
  const MapModules modules(flat_map(2, 2));
  M::GnomonLight taken = light();
  EXPECT_NEAR(modules.gnomon_cascade_bias(taken, 2, 1), 1.0F, 1e-4F) << "half a texel";
  taken.slope_bias = 1;
  EXPECT_NEAR(modules.gnomon_cascade_bias(taken, 2, kDiagonal), 3.0F, 1e-4F) << "and one for 45 degrees";
  taken.filter_width = 5;
  EXPECT_NEAR(modules.gnomon_cascade_bias(taken, 2, kDiagonal), 7.0F, 1e-4F) << "and two for the filter";
  EXPECT_LT(modules.gnomon_cascade_bias(taken, 2, 0), 400.0F) << "bounded at grazing light";
}

TEST(CascadeShare, CountsTheFiltersTexels) {
  MapModules modules(flat_map(2, 2));
  modules.light_nearness = [](ivec2 texel, int) { return texel.x < 10 ? 1.0F : 0.0F; };
  M::GnomonLight taken = light();
  taken.filter_width = 3;
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_share(taken, 0, vec2(5.5F, 5.5F), 0.5F), 1.0F);
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_share(taken, 0, vec2(9.5F, 5.5F), 0.5F), 2.0F / 3);
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_share(taken, 0, vec2(10.5F, 5.5F), 0.5F), 1.0F / 3);
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_share(taken, 0, vec2(20, 5.5F), 0.5F), 0.0F);
}

TEST(CascadeLift, IsLessTheHigherAReceiverStandsAndNoneForGroundThatFacesAway) {
  const MapModules modules(flat_map(2, 2));
  M::GnomonLight taken = light();
  taken.slope_bias = 1;
  const M::GnomonGridPoint flat{.height = 0, .normal = vec3(0, 0, 1), .hole = false};
  const float least = modules.gnomon_cascade_bias(taken, 2, 1);
  const float whole = modules.gnomon_cascade_bias(taken, 2, kDiagonal);
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_lift(taken, 2, flat, kToSun, 0), whole);
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_lift(taken, 2, flat, kToSun, 1), whole - 1 / kDiagonal);
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_lift(taken, 2, flat, kToSun, 100), least);
  const M::GnomonGridPoint away{.height = 0, .normal = vec3(-0.8F, 0, 0.6F), .hole = false};
  EXPECT_FLOAT_EQ(modules.gnomon_cascade_lift(taken, 2, away, kToSun, 0.001F), least);
}

TEST(TowardsSun, MovesAThousandthOfATexelButNotOffTheMapNorIntoAHole) {
  terrain::HeightMap map = flat_map(4, 4);
  const MapModules modules(map);
  const auto place = [](const M::GnomonReceiver& r) { return vec2(r.patch_index) - vec2(0.5F) + r.fraction; };
  const auto middle = modules.gnomon_receiver_at(2, 2, 3);
  const auto moved = modules.gnomon_towards_sun(modules.map(), middle, normalize(vec3(3, 4, 1)), 0);
  EXPECT_NEAR(place(moved).x, 2.0006F, 1e-6F);
  EXPECT_NEAR(place(moved).y, 1.9992F, 1e-6F) << "north is up the rows";
  EXPECT_EQ(moved.height, 3.0F);
  const auto edge = modules.gnomon_receiver_at(4, 2, 0);
  EXPECT_EQ(place(modules.gnomon_towards_sun(modules.map(), edge, vec3(1, 0, 0), 0)), vec2(4, 2));
  map.samples[6] = terrain::kNoSample;  // column 2, row 1
  map.holes = true;
  const MapModules with_hole(map);
  const auto beside = with_hole.gnomon_receiver_at(1.5F, 1.5F, 0);
  const auto kept = with_hole.gnomon_towards_sun(with_hole.map(), beside, vec3(1, 0, 0), 0);
  EXPECT_EQ(place(kept), vec2(1.5F, 1.5F));
  EXPECT_TRUE(with_hole.gnomon_patch_has_surface(kept.patch_index, 0));
}

TEST(MeshUnder, IsTheSurfaceItselfWhereAHoleCutsTheTriangleAway) {
  terrain::HeightMap map = flat_map(9, 9, 7);
  map.samples[0] = terrain::kNoSample;
  map.holes = true;
  const MapModules modules(map);
  const auto receiver = modules.gnomon_receiver_at(2.5F, 1.5F, 0);
  EXPECT_TRUE(modules.gnomon_grid_point(modules.map(), 2.5F, 1.5F, 4, 0).hole);
  const auto on = modules.gnomon_mesh_under(modules.map(), receiver, 4, 0);
  EXPECT_EQ(on.height, 7.0F);
  EXPECT_EQ(on.normal, vec3(0, 0, 1));
}

}  // namespace
}  // namespace gnomon::modules
