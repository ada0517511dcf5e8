// SPDX-License-Identifier: MIT
// What must hold of point lists, for levels that lie as in pictures and for some that lie anyhow.
#include "technique/point_list.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "technique/tiles.h"

namespace gnomon::technique {
namespace {

Ground ground_of(glm::ivec2 size) {
  Ground ground = empty_ground(size, {.q = 0});
  ground.valid.assign(ground.pixels(), 1.0F);
  return ground;
}

/// How often each pixel stands in bands of its own level; fails for one in a band of another level.
std::map<std::size_t, int> listed(const Ground& ground, const std::vector<PointList>& lists) {
  std::map<std::size_t, int> times;
  for (const PointList& list : lists) {
    for (const Band& band : list) {
      for (const std::size_t pixel : band.pixels) {
        EXPECT_EQ(static_cast<int>(ground.q[pixel]), band.q);
        EXPECT_EQ(ground.valid[pixel], 1.0F);
        ++times[pixel];
      }
    }
  }
  return times;
}

/// Each window lies in its texture, below the one before, and has a pixel for every texel.
void expect_sound(const PointList& list) {
  EXPECT_LE(size_of(list).x, kTile);
  EXPECT_LE(size_of(list).y, 2.2 * kTile);
  int row = 0;
  for (const Band& band : list) {
    EXPECT_EQ(band.window.first, glm::ivec2(0, row));
    row += band.window.size.y;
    EXPECT_EQ(band.pixels.size(), static_cast<std::size_t>(band.window.size.x * band.window.size.y));
  }
}

TEST(PointLists, HoldEveryAskingPixelInABandOfItsLevel) {
  std::mt19937 random(7);
  for (const glm::ivec2 size : {glm::ivec2(1, 1), {8, 8}, {9, 7}, {130, 61}, {1500, 900}}) {
    Ground ground = ground_of(size);
    std::size_t asking = 0;
    for (std::size_t i = 0; i < ground.pixels(); ++i) {
      ground.q[i] = static_cast<float>(random() % 3);
      ground.valid[i] = random() % 5 > 0 ? 1.0F : 0.0F;
      asking += ground.valid[i] != 0 ? 1 : 0;
    }
    const std::vector<PointList> lists = point_lists(ground, ground.levels());
    for (const PointList& list : lists) expect_sound(list);
    EXPECT_EQ(listed(ground, lists).size(), asking) << size.x << " x " << size.y;
  }
}

TEST(PointLists, LeaveOutLevelsThatAreNotAskedFor) {
  Ground ground = ground_of({16, 16});
  ground.q[5] = 1;
  const std::vector<PointList> lists = point_lists(ground, {1, 4});
  EXPECT_EQ(listed(ground, lists).size(), 1U);
  EXPECT_TRUE(point_lists(ground, {2}).empty());
}

TEST(PointLists, AMissingPixelMovesNoneOutOfItsSquare) {
  Ground ground = ground_of({64, 64});
  ground.valid[0] = ground.valid[70] = 0;
  const Band band = point_lists(ground, {0}).front().front();
  ASSERT_EQ(band.pixels.size(), ground.pixels());
  for (std::size_t i = 0; i < band.pixels.size(); i += 8) {
    const std::size_t first = band.pixels[i + 7] - 7;  // of a square's row; never missing here
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_TRUE(ground.valid[first + k] == 0 || band.pixels[i + k] == first + k);
    }
  }
}

TEST(PointLists, PixelsAloneInTheirSquaresCloseUp) {
  Ground ground = ground_of({800, 800});
  for (int y = 0; y < 800; y += 8)
    for (int x = 0; x < 800; x += 8) ground.q[ground.index({x, y})] = 3;
  const std::vector<PointList> lists = point_lists(ground, {3});
  ASSERT_EQ(lists.size(), 1U);
  EXPECT_LE(lists.front().front().pixels.size(), 10112U);  // 10,000, in 158 squares of 64
}

TEST(PointLists, FillATextureBeforeTheyBeginAnother) {
  EXPECT_EQ(point_lists(ground_of({1920, 1080}), {0}).size(), 1U);
  const Ground ground = ground_of({2048, 1600});
  const std::vector<PointList> lists = point_lists(ground, {0});
  ASSERT_EQ(lists.size(), 2U);
  EXPECT_GT(size_of(lists[0]).y, 2 * kTile);
  EXPECT_EQ(listed(ground, lists).size(), ground.pixels());
}

}  // namespace
}  // namespace gnomon::technique
