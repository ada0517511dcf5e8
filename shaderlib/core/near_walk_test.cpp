// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

// Ground that rises `slope` metres a texel eastward, at an altitude where a float's steps are 0.5 mm.
terrain::HeightMap plane(float slope) {
  terrain::HeightMap map = flat_map(16, 16, 4096);
  for (std::size_t i = 0; i < map.samples.size(); ++i) map.samples[i] += slope * static_cast<float>(i % 16);
  return map;
}

Modules::GnomonCursor walk(const MapModules& modules, float column, float height, vec3 to_sun) {
  const auto receiver = modules.gnomon_receiver_at(column, 7.3F, height);
  return modules.gnomon_near_walk(modules.gnomon_ray(modules.map(), receiver, to_sun, 0), height, 0);
}

TEST(NearWalk, GroundHidesTheSunExactlyWhereItIsSteeperThanTheRay) {
  for (const float slope : {0.25F, 1.0F, 8.0F}) {
    const MapModules modules(plane(slope));
    for (float column = 1; column < 12; column += 0.37F) {
      const auto cause = [&](float tan_elevation) {
        return walk(modules, column, 0, vec3(1, 0, tan_elevation)).cause;
      };
      EXPECT_EQ(cause(std::nextafter(slope, 0.0F)), GNOMON_CAUSE_SURFACE);
      EXPECT_EQ(cause(slope), GNOMON_CAUSE_UNDECIDED) << "grazing is not shadow";
      EXPECT_EQ(cause(std::nextafter(slope, 9.0F)), GNOMON_CAUSE_UNDECIDED);
    }
  }
}

TEST(NearWalk, HeightAboveTheGroundIsClearance) {
  const MapModules modules(plane(1));
  EXPECT_EQ(walk(modules, 3, 0.1F, vec3(1, 0, 0.5F)).cause, GNOMON_CAUSE_SURFACE);
  EXPECT_EQ(walk(modules, 3, 0.9F, vec3(1, 0, 0.5F)).cause, GNOMON_CAUSE_UNDECIDED);
}

TEST(NearWalk, EndsBehindTheFirstTexelWithinItsBound) {
  const MapModules modules(flat_map(16, 16));
  for (int azimuth = 0; azimuth < 360; ++azimuth) {
    const float angle = glm::radians(static_cast<float>(azimuth));
    const auto cursor = walk(modules, 8.1F, 0, vec3(std::sin(angle), std::cos(angle), 0.2F));
    EXPECT_GE(cursor.t, 1.0F) << azimuth;
    EXPECT_LE(cursor.steps, GNOMON_NEAR_PATCHES) << azimuth;
  }
}

TEST(NearWalk, EndsAtTheEdgeOfTheMap) {
  const MapModules modules(flat_map(16, 16));
  EXPECT_EQ(walk(modules, 15.9F, 0, vec3(1, 0, 0.2F)).cause, GNOMON_CAUSE_LEFT_MAP);
}

TEST(CarriedClearance, IsThatAtTheExitButNeverAboveTheRaySaveOverAHole) {
  const MapModules modules(flat_map(2, 2));
  Modules::GnomonCrossing rising{.slope = 2, .curvature = 0, .above = 0, .hole = false};
  EXPECT_EQ(modules.gnomon_carried_clearance(rising, -3, 1), -1.0F);
  EXPECT_EQ(modules.gnomon_carried_clearance(rising, -1, 1), 0.0F);
  EXPECT_EQ(modules.gnomon_carried_clearance(rising, -3, 0), -3.0F) << "only touched";
  rising.hole = true;
  EXPECT_EQ(modules.gnomon_carried_clearance(rising, -1, 1), 1.0F);
}

}  // namespace
}  // namespace gnomon::modules
