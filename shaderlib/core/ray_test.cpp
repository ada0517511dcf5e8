// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

using Crossing = Modules::GnomonCrossing;

const MapModules& hills() {
  static const MapModules modules(
      terrain::make_procedural(
          {.kind = "fractal", .width = 40, .height = 30, .seed = 5, .spacing_x = 10, .spacing_y = 20})
          .value());
  return modules;
}

vec3 sun(int azimuth, float tangent) {
  const double angle = azimuth * std::numbers::pi / 180;
  return vec3(std::sin(angle), std::cos(angle), tangent);
}

Modules::GnomonRay ray_from(float column, float row, vec3 to_sun) {
  return hills().gnomon_ray(hills().map(), hills().gnomon_receiver_at(column, row, 0), to_sun, 0);
}

TEST(Patch, IsTheSamplesAtItsCornersAndTheirMeanInTheMiddle) {
  terrain::HeightMap map = flat_map(2, 2);
  map.samples = {10, 20, 40, 80};
  const MapModules modules(map);
  const auto patch = modules.gnomon_patch(ivec2(1, 1), 10, 0);
  EXPECT_EQ(modules.gnomon_patch_height(patch, vec2(0, 0)), 0.0F);
  EXPECT_EQ(modules.gnomon_patch_height(patch, vec2(1, 0)), 10.0F);
  EXPECT_EQ(modules.gnomon_patch_height(patch, vec2(0, 1)), 30.0F);
  EXPECT_EQ(modules.gnomon_patch_height(patch, vec2(1, 1)), 70.0F);
  EXPECT_EQ(modules.gnomon_patch_height(patch, vec2(0.5F, 0.5F)), 27.5F);
}

TEST(PatchHeight, NeighboursMeetWithoutAStep) {
  const float step = 1e-6F * (hills().map().highest + 1);
  for (int i = 0; i <= 40; ++i) {
    const auto west = hills().gnomon_patch(ivec2(i, 7), 0, 0);
    const auto east = hills().gnomon_patch(ivec2(i + 1, 7), 0, 0);
    for (float y = 0; y <= 1; y += 0.125F)
      EXPECT_NEAR(hills().gnomon_patch_height(west, vec2(1, y)),
                  hills().gnomon_patch_height(east, vec2(0, y)), step);
  }
}

TEST(EnterPatch, MovesAStartOnAnEdgeIntoThePatchAhead) {
  for (const float direction : {-1.0F, -0.25F, 0.0F, 1.0F}) {
    for (const float at : {0.0F, 0.5F, 1.0F}) {
      int patch = -1;
      float fraction = -1;
      hills().gnomon_enter_patch(direction, patch, fraction, 7, at);
      EXPECT_EQ(static_cast<float>(patch) + fraction, 7 + at) << "the place stays";
      EXPECT_LT(direction < 0 ? 1 - fraction : fraction, 1.0F) << "there is way ahead in the patch";
    }
  }
}

TEST(Inverse, IsFiniteAndTheReciprocal) {
  EXPECT_EQ(hills().gnomon_inverse(-0.25F), -4.0F);
  EXPECT_EQ(hills().gnomon_inverse(0), GNOMON_NEVER);
}

TEST(DomainExit, IsNeverForARayAlongTheEdge) {
  EXPECT_EQ(hills().gnomon_domain_exit(3, 0.5F), 6.0F);
  EXPECT_EQ(hills().gnomon_domain_exit(-3, -0.5F), 6.0F);
  EXPECT_EQ(hills().gnomon_domain_exit(0, 0), GNOMON_NEVER);
}

TEST(Ray, StartsOnTheGroundAtTheReceiverAndEndsOnTheEdgeOfTheMap) {
  for (int azimuth = 0; azimuth < 360; azimuth += 5) {
    const auto ray = ray_from(17.3F, 11.9F, sun(azimuth, 0.5F));
    const vec2 start = vec2(ray.start) + ray.fraction - 0.5F;
    EXPECT_NEAR(start.x, 17.3F, 1e-5F);
    EXPECT_NEAR(start.y, 11.9F, 1e-5F);
    const auto patch = hills().gnomon_patch(ray.start, ray.base, 0);
    EXPECT_EQ(ray.height, hills().gnomon_patch_height(patch, ray.fraction));
    EXPECT_EQ(std::max(std::abs(ray.direction.x), std::abs(ray.direction.y)), 1.0F);
    const vec2 end = start + ray.direction * ray.t_end;
    const float to_edge = std::min({end.x, 40 - end.x, end.y, 30 - end.y});
    EXPECT_NEAR(to_edge, 0, 1e-4F) << azimuth;
  }
}

TEST(Ray, RisesByTheTangentOfTheElevationOverTheGroundInMetres) {
  for (int azimuth = 0; azimuth < 360; azimuth += 5) {
    const auto ray = ray_from(17.3F, 11.9F, sun(azimuth, 0.5F));
    EXPECT_NEAR(ray.rise, 0.5F * std::hypot(ray.direction.x * 10, ray.direction.y * 20), 1e-5F);
  }
}

TEST(RayExits, LieOnTheEdgesOfTheBlock) {
  for (int azimuth = 5; azimuth < 360; azimuth += 10) {
    const auto ray = ray_from(17.3F, 11.9F, sun(azimuth, 0.5F));
    for (int level = 0; level < 4; ++level) {
      const ivec2 low = (ray.start >> level) << level;
      const vec2 exits = hills().gnomon_ray_exits(ray, low, level);
      const vec2 edge = vec2(low) + vec2(ray.forward * (1 << level));
      const vec2 start = vec2(ray.start) + ray.fraction;
      EXPECT_NEAR(start.x + ray.direction.x * exits.x, edge.x, 1e-4F);
      EXPECT_NEAR(start.y + ray.direction.y * exits.y, edge.y, 1e-4F);
    }
  }
}

TEST(RayNext, StepsToEveryPatchUnderItWithoutTurningBack) {
  for (int i = 0; i < 720; ++i) {
    const auto angle = static_cast<float>(i * 0.5 * std::numbers::pi / 180);
    const auto ray = ray_from(17.3F, 11.9F, vec3(std::sin(angle), std::cos(angle), 0.5F));
    ivec2 patch = ray.start;
    float t = 0;
    int steps = 0;
    for (; t < ray.t_end && steps < 200; ++steps) {
      const vec2 exits = hills().gnomon_ray_exits(ray, patch, 0);
      const ivec2 next = hills().gnomon_ray_next(ray, patch, patch, 0, exits);
      const ivec2 moved = glm::abs(next - patch);
      EXPECT_TRUE(moved.x <= 1 && moved.y <= 1 && moved.x + moved.y >= 1);
      EXPECT_GE(std::min(exits.x, exits.y), t - 1e-5F);
      patch = next;
      t = std::min(exits.x, exits.y);
    }
    EXPECT_LT(steps, 80) << "azimuth " << i * 0.5;
  }
}

TEST(Crossing, ClearanceIsTheSurfaceAboveTheRayAllAlongThePatch) {
  const float step = 1e-5F * hills().map().highest;
  for (int azimuth = 5; azimuth < 360; azimuth += 10) {
    const auto ray = ray_from(17.3F, 11.9F, sun(azimuth, 0.5F));
    const vec2 exits = hills().gnomon_ray_exits(ray, ray.start, 0);
    const float length = std::min(exits.x, exits.y);
    const Crossing crossing = hills().gnomon_crossing(ray, ray.start, 0, 0);
    const auto patch = hills().gnomon_patch(ray.start, ray.base, 0);
    EXPECT_EQ(crossing.above, ray.height) << "the receiver stands on the ground";
    for (float s = 0; s <= length; s += length / 8) {
      const float surface = hills().gnomon_patch_height(patch, ray.fraction + ray.direction * s);
      EXPECT_NEAR(hills().gnomon_clearance_at(crossing, crossing.above - ray.height, s),
                  surface - (ray.height + ray.rise * s), step);
    }
  }
}

TEST(ClearanceAt, BeginsAtTheEntry) {
  EXPECT_EQ(hills().gnomon_clearance_at({.slope = 3, .curvature = -2, .above = 9}, -0.5F, 0), -0.5F);
  EXPECT_EQ(hills().gnomon_clearance_at({.slope = 3, .curvature = -2, .above = 9}, -0.5F, 1), 0.5F);
}

TEST(CrossingHides, ParabolaTopInsideAPatchIsSeen) {
  const Crossing hill{.slope = 2.0F, .curvature = -2.0F, .above = 0};
  EXPECT_TRUE(hills().gnomon_crossing_hides(hill, -0.499F, 1.0F));
  EXPECT_FALSE(hills().gnomon_crossing_hides(hill, -0.501F, 1.0F));
  EXPECT_FALSE(hills().gnomon_crossing_hides(hill, -0.499F, 0.4F)) << "the top lies beyond this length";
}

TEST(CrossingHides, GrazingIsNotShadow) {
  EXPECT_FALSE(hills().gnomon_crossing_hides({.slope = 0, .curvature = 0, .above = 0}, 0, 1));
  EXPECT_TRUE(hills().gnomon_crossing_hides({.slope = 1e-20F, .curvature = 0, .above = 0}, 0, 1));
  EXPECT_FALSE(hills().gnomon_crossing_hides({.slope = 1, .curvature = 0, .above = 0}, 0, 0)) << "touched";
}

// A wall of 6 m three texels to the east of the receiver, asked about in the patch on its west side.
TEST(FarPatchHides, AWallUpToItsTop) {
  terrain::HeightMap map = flat_map(8, 3, 100);
  for (int row = 0; row < 3; ++row) map.samples[static_cast<std::size_t>(row * 8 + 5)] = 106;
  const MapModules modules(map);
  const auto receiver = modules.gnomon_receiver_at(2.5F, 1.5F, 0);
  for (const float tangent : {1.9F, 2.1F}) {
    const auto ray = modules.gnomon_ray(modules.map(), receiver, vec3(1, 0, tangent), 0);
    const vec2 exits = modules.gnomon_ray_exits(ray, ivec2(5, 2), 0);
    EXPECT_EQ(
        modules.gnomon_far_patch_hides(ray, modules.gnomon_crossing(ray, ivec2(5, 2), 2, 0), 2, exits, false),
        tangent < 2)
        << tangent;
  }
}

TEST(FarClearance, IsTheSurfaceAboveTheRayButNotAboveItExceptBehindAHole) {
  const MapModules modules(flat_map(2, 2));
  Modules::GnomonRay ray{};
  ray.height = 10;
  ray.rise = 2;
  Modules::GnomonCrossing crossing{.slope = 0, .curvature = 0, .above = 15, .hole = false};
  EXPECT_EQ(modules.gnomon_far_clearance(ray, crossing, 3, false), -1.0F);
  crossing.above = 20;
  EXPECT_EQ(modules.gnomon_far_clearance(ray, crossing, 3, false), 0.0F);
  EXPECT_EQ(modules.gnomon_far_clearance(ray, crossing, 3, true), 4.0F);
}

// Sample (3, 2) of a slope is no sample.
MapModules pierced() {
  terrain::HeightMap map = flat_map(8, 6, 100);
  for (std::size_t i = 0; i < map.samples.size(); ++i)
    map.samples[i] += static_cast<float>(i % 8 + 2 * (i / 8));
  map.samples[2 * 8 + 3] = GNOMON_NO_SAMPLE;
  return MapModules(map);
}

TEST(Patch, WithOneCornerMissingHasTheSlopesOfTheOtherThree) {
  const MapModules modules = pierced();
  for (const ivec2 patch : {ivec2(3, 2), ivec2(4, 2), ivec2(3, 3), ivec2(4, 3)}) {
    const auto p = modules.gnomon_patch(patch, 100, 0);
    EXPECT_TRUE(p.hole);
    EXPECT_EQ(p.slope, vec2(1, 2));
    EXPECT_EQ(p.twist, 0);
  }
  EXPECT_FALSE(modules.gnomon_patch(ivec2(2, 2), 100, 0).hole);
  EXPECT_TRUE(modules
                  .gnomon_crossing(modules.gnomon_ray(modules.map(), modules.gnomon_receiver_at(1, 3, 0),
                                                      vec3(1, 0, 1), 0),
                                   ivec2(3, 3), 1.5F, 0)
                  .hole);
}

// On the edge of a hole, with the ray over it: the height is that of the edge, whatever the missing corner.
TEST(RayFromGround, StandsOnTheEdgeOfAHole) {
  const MapModules modules = pierced();
  for (const float along : {0.0F, 0.25F, 1.0F}) {
    // The east side of patch (2, 3), and the west side of the hole's patch (3, 3).
    const auto receiver = modules.gnomon_receiver_at(2.5F, 2.5F + along, 0.5F);
    const auto ray = modules.gnomon_ray(modules.map(), receiver, vec3(1, 0, 1), 0);
    EXPECT_EQ(ray.base + ray.height, 102 + 4 + 2 * along + 0.5F) << along;
    const auto again = modules.gnomon_ray_from_ground(ray, 0.5F, 99, 0);
    EXPECT_EQ(again.base, ray.base);
    EXPECT_EQ(again.height, ray.height);
  }
  // Its north-west corner is the one that is missing.
  const auto inside =
      modules.gnomon_ray(modules.map(), modules.gnomon_receiver_at(4.5F, 2.75F, 0), vec3(-1, 0, 1), 0);
  EXPECT_GT(inside.base, 0);
  EXPECT_EQ(inside.base + inside.height, 104 + 4.5F);
}

TEST(RayFromGround, WithoutAnyCornerTakesTheDatum) {
  terrain::HeightMap map = flat_map(8, 8, 100);
  for (const std::size_t i : {27, 28, 35, 36}) map.samples[i] = GNOMON_NO_SAMPLE;  // around patch (4, 4)
  const MapModules modules(map);
  const auto ray = modules.gnomon_ray(modules.map(), modules.gnomon_receiver_at(4, 4, 0), vec3(1, 0, 1), 0);
  EXPECT_EQ(ray.base, 100);
  EXPECT_EQ(modules.gnomon_ray_from_ground(ray, 0, 77, 0).base, 77);
}

TEST(OtherSide, IsTheSameRayOnTheWestOrNorth) {
  const MapModules modules(flat_map(8, 8));
  const auto ray_towards = [&](float column, float row, vec3 sun) {
    return modules.gnomon_ray(modules.map(), modules.gnomon_receiver_at(column, row, 0), sun, 0);
  };
  EXPECT_FALSE(modules.gnomon_ray_on_edges(ray_towards(3, 3.5F, vec3(0, 1, 1))));
  EXPECT_FALSE(modules.gnomon_ray_on_edges(ray_towards(3.5F, 3.5F, vec3(1, 1, 1))));
  const auto north = ray_towards(3.5F, 5.5F, vec3(0, 1, 1));
  ASSERT_TRUE(modules.gnomon_ray_on_edges(north));
  const auto other = modules.gnomon_ray_other_side(north);
  EXPECT_EQ(other.start, north.start - ivec2(1, 0));
  EXPECT_EQ(vec2(other.start) + other.fraction, vec2(north.start) + north.fraction);
  // It walks up the other column of patches, to the north edge, at every level.
  for (const int level : {0, 1, 2}) {
    const ivec2 low = (other.start >> level) << level;
    const vec2 exits = modules.gnomon_ray_exits(other, low, level);
    EXPECT_GT(exits.x, 1e6F);
    EXPECT_EQ(exits.y, static_cast<float>(5 - low.y + 1));
    EXPECT_EQ(modules.gnomon_ray_next(other, other.start, low, level, exits), ivec2(3, low.y - 1));
  }
  const auto east = modules.gnomon_ray_other_side(ray_towards(3.5F, 5.5F, vec3(1, 0, 1)));
  EXPECT_EQ(east.start, ivec2(4, 5));
  EXPECT_EQ(east.fraction, vec2(0, 1));
}

TEST(Crossed, EndsWithTheDomain) {
  const MapModules modules(flat_map(8, 8));
  const auto ray = modules.gnomon_ray(modules.map(), modules.gnomon_receiver_at(3, 3, 0), vec3(1, 0, 1), 0);
  EXPECT_EQ(modules.gnomon_crossed(ray, 0.25F, vec2(1.5F, 9)), 1.25F);
  EXPECT_EQ(modules.gnomon_crossed(ray, 4.5F, vec2(6, 9)), 0.5F);
}

TEST(CrossingHides, WhereTheSurfaceBeginsAboveTheRay) {
  EXPECT_TRUE(hills().gnomon_crossing_hides({.slope = -5, .curvature = 0, .above = 0}, 0.1F, 1));
  EXPECT_FALSE(
      hills().gnomon_crossing_hides({.slope = 5, .curvature = 0, .above = 0, .hole = true}, 0.1F, 1));
}

}  // namespace
}  // namespace gnomon::modules
