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

TEST(CursorAtStart, StandsWhereTheRayStarts) {
  const auto cursor = kFlat.gnomon_cursor_at_start(eastward());
  EXPECT_EQ(cursor.patch_index, ivec2(3, 3));
  EXPECT_EQ(cursor.t, 0);
  EXPECT_EQ(cursor.steps, 0);
  EXPECT_EQ(cursor.cause, GNOMON_CAUSE_UNDECIDED);
  EXPECT_FALSE(cursor.after_hole || cursor.met_hole);
}

TEST(LeavePatch, RemembersHoles) {
  const auto ray = eastward();
  const Modules::GnomonCursor first{.patch_index = ivec2(3, 3), .t = 0};
  const vec2 exits = kFlat.gnomon_ray_exits(ray, first.patch_index, 0);
  const auto behind = kFlat.gnomon_leave_patch(ray, first, {.hole = true}, exits, 100);
  EXPECT_EQ(behind.patch_index, ivec2(4, 3));
  EXPECT_TRUE(behind.after_hole && behind.met_hole);
  const vec2 next = kFlat.gnomon_ray_exits(ray, behind.patch_index, 0);
  const auto onward = kFlat.gnomon_leave_patch(ray, behind, {}, next, 100);
  EXPECT_FALSE(onward.after_hole);
  EXPECT_TRUE(onward.met_hole);
  // A patch that is only touched does not count.
  EXPECT_TRUE(kFlat.gnomon_leave_patch(ray, behind, {}, vec2(behind.t, 9), 100).after_hole);
  EXPECT_FALSE(kFlat.gnomon_leave_block(ray, behind, behind.patch_index, 0, next, 100).after_hole);
}

TEST(RepeatOnOtherSide, OnlyForARayAlongEdgesThatMetAHoleAndNothingElse) {
  const auto ray = kFlat.gnomon_ray(kFlat.map(), kFlat.gnomon_receiver_at(3.5F, 3, 0), vec3(0, 1, 1), 0);
  const auto repeated = [&](int cause, bool met_hole) {
    return kFlat.gnomon_repeat_on_other_side(ray, {.cause = cause, .met_hole = met_hole});
  };
  EXPECT_TRUE(repeated(GNOMON_CAUSE_LEFT_MAP, true));
  EXPECT_TRUE(repeated(GNOMON_CAUSE_ABOVE_ALL, true));
  EXPECT_FALSE(repeated(GNOMON_CAUSE_ABOVE_ALL, false));
  EXPECT_FALSE(repeated(GNOMON_CAUSE_SURFACE, true));
  EXPECT_FALSE(repeated(GNOMON_CAUSE_UNDECIDED, true));
  EXPECT_FALSE(
      kFlat.gnomon_repeat_on_other_side(eastward(), {.cause = GNOMON_CAUSE_LEFT_MAP, .met_hole = true}));
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
