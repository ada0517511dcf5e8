// SPDX-License-Identifier: MIT
// relief/multilevel_test.cpp holds this method against the oracle; here is what can be said without one.
#include <gtest/gtest.h>

#include <cmath>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

constexpr float kWall = 6;  // metres above the ground, in column 40

terrain::HeightMap wall() {
  terrain::HeightMap map = flat_map(64, 8, 100);
  for (int row = 0; row < 8; ++row) map.samples[static_cast<std::size_t>(row * 64 + 40)] += kWall;
  return map;
}

TEST(BruteForce, WallCastsItsHeightOverTheTangentOfTheElevation) {
  const MapModules modules(wall());
  for (const float tangent : {0.2F, 0.3F, 0.7F, 1.5F}) {
    const float tip = 40.5F - kWall / tangent;
    const auto shadow = [&](float column) {
      const auto receiver = modules.gnomon_receiver_at(column, 4, 0);
      return modules.gnomon_brute_force(modules.map(), receiver, vec3(1, 0, tangent), 0,
                                        modules.step_limit());
    };
    EXPECT_EQ(shadow(tip + 0.01F).shadow, 1.0F) << tangent;
    EXPECT_EQ(shadow(tip - 0.01F).shadow, 0.0F) << tangent;
    EXPECT_EQ(shadow(41.5F).shadow, 0.0F) << "behind the wall the sun shines";
  }
}

TEST(BruteForce, StepLimitLeavesItUndecided) {
  const MapModules modules(wall());
  const auto receiver = modules.gnomon_receiver_at(2, 4, 0);
  const auto answer = modules.gnomon_brute_force(modules.map(), receiver, vec3(1, 0, 0.01F), 0, 20);
  EXPECT_EQ(answer.cause, GNOMON_CAUSE_UNDECIDED);
  EXPECT_EQ(answer.steps, 20);
}

}  // namespace
}  // namespace gnomon::modules
