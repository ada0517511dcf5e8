// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

TEST(Climb, OneLevelWhereTheParentBlockChangesUpToTheTop) {
  const MapModules modules(flat_map(4, 4));
  EXPECT_EQ(modules.gnomon_climb(ivec2(6, 6), ivec2(7, 6), 0, 7), 0) << "both lie in block (3, 3)";
  EXPECT_EQ(modules.gnomon_climb(ivec2(7, 6), ivec2(8, 6), 0, 7), 1);
  EXPECT_EQ(modules.gnomon_climb(ivec2(7, 6), ivec2(7, 5), 0, 7), 1);
  EXPECT_EQ(modules.gnomon_climb(ivec2(7, 6), ivec2(8, 6), 3, 7), 3) << "both lie in block (0, 0) of level 4";
  EXPECT_EQ(modules.gnomon_climb(ivec2(127, 6), ivec2(128, 6), 3, 7), 4);
  EXPECT_EQ(modules.gnomon_climb(ivec2(255, 6), ivec2(256, 6), 7, 7), 7);
  EXPECT_EQ(modules.gnomon_climb(ivec2(0, 0), ivec2(-1, 0), 2, 7), 3) << "west of the map";
}

}  // namespace
}  // namespace gnomon::modules
