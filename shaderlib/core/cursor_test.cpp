// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(8, 8));

// From the middle of patch (3, 3) of an 8 x 8 map, eastward and 1 m up a texel.
Modules::GnomonRay eastward() {
  return kFlat.gnomon_ray(kFlat.map(), kFlat.gnomon_receiver_at(3, 3, 0), vec3(1, 0, 1), 0);
}

TEST(LeaveBlock, GoesOnInsideTheMapAndNeverBackInT) {
  const auto ray = eastward();
  const Modules::GnomonCursor cursor{.patch_index = ivec2(3, 3), .t = 0.75F, .steps = 5, .cause = 0};
  const vec2 exits = kFlat.gnomon_ray_exits(ray, cursor.patch_index, 0);
  const auto next = kFlat.gnomon_leave_block(ray, cursor, cursor.patch_index, 0, exits, 100);
  EXPECT_EQ(next.patch_index, ivec2(4, 3));
  EXPECT_EQ(next.t, 0.75F) << "the exit at 0.5 lies behind";
  EXPECT_EQ(next.steps, 5);
  EXPECT_EQ(next.cause, GNOMON_CAUSE_UNDECIDED);
}

TEST(LeaveBlock, EndsWhereTheRayLeavesTheMapOrRisesAboveAll) {
  const auto ray = eastward();
  const Modules::GnomonCursor last{.patch_index = ivec2(8, 3), .t = 4.5F, .steps = 5, .cause = 0};
  const vec2 exits = kFlat.gnomon_ray_exits(ray, last.patch_index, 0);
  EXPECT_EQ(kFlat.gnomon_leave_block(ray, last, last.patch_index, 0, exits, 100).cause,
            GNOMON_CAUSE_LEFT_MAP);
  EXPECT_EQ(kFlat.gnomon_leave_block(ray, last, last.patch_index, 0, exits, 5).cause, GNOMON_CAUSE_ABOVE_ALL);
}

TEST(TAbove, IsWhereTheRayIsAsHighAsTheHighestSample) {
  auto map = kFlat.map();
  map.highest = 12;  // 7 m above the ground
  const auto ray = eastward();
  EXPECT_EQ(ray.base + ray.height + ray.rise * kFlat.gnomon_t_above(map, ray), 12.0F);
}

TEST(WalkAnswer, OnlyTheSurfaceCastsShadow) {
  for (int cause = GNOMON_CAUSE_UNDECIDED; cause <= GNOMON_CAUSE_ABOVE_ALL; ++cause) {
    const auto answer = kFlat.gnomon_walk_answer({.patch_index = {}, .t = 0, .steps = 9, .cause = cause});
    EXPECT_EQ(answer.shadow, cause == GNOMON_CAUSE_SURFACE ? 1.0F : 0.0F);
    EXPECT_EQ(answer.steps, 9);
    EXPECT_EQ(answer.cause, cause);
  }
}

}  // namespace
}  // namespace gnomon::modules
