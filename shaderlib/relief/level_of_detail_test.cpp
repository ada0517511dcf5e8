// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kModules(flat_map(4, 4));

int level(vec2 along_x, vec2 along_y, float largest = 16, int coarsest = 14) {
  return kModules.gnomon_level_of_detail(along_x, along_y, largest, coarsest);
}

TEST(Anisotropy, CountsTheShorterSidesInTheLongerOne) {
  EXPECT_EQ(kModules.gnomon_anisotropy(1, 1, 16), 1);
  EXPECT_EQ(kModules.gnomon_anisotropy(9, 1, 16), 3) << "exact: not rounded up to 4";
  EXPECT_EQ(kModules.gnomon_anisotropy(9.1F, 1, 16), 4);
  EXPECT_EQ(kModules.gnomon_anisotropy(1e6F, 1, 16), 16);
  EXPECT_EQ(kModules.gnomon_anisotropy(5, 0, 16), 16) << "a pixel seen edge on";
}

TEST(Anisotropy, DoesNotFollowTheNoiseOfAnExactRatio) {
  for (int k = 1; k <= 16; ++k) {
    for (float shorter = 0.01F; shorter < 1e4F; shorter *= 1.37F) {
      const auto ratio = static_cast<float>(k * k);
      for (const float noise : {-2e-6F, 0.0F, 2e-6F})
        EXPECT_EQ(kModules.gnomon_anisotropy(ratio * shorter * (1 + noise), shorter, 16), k);
    }
  }
}

TEST(LevelOfDetail, OfASquarePixelIsTheLogarithmOfItsSide) {
  for (int k = 0; k < 14; ++k) {
    const float side = std::ldexp(1.0F, k);
    EXPECT_EQ(level({side, 0}, {0, side}), k);
    EXPECT_EQ(level({side * 1.9F, 0}, {0, side * 1.9F}), k) << "rounded down";
    EXPECT_EQ(level({side * 0.999F, 0}, {0, side * 0.999F}), std::max(k - 1, 0));
  }
}

TEST(LevelOfDetail, DoesNotFollowTheNoiseOfAnExactPowerOfTwo) {
  for (int k = 1; k < 14; ++k) {
    const float side = std::ldexp(1.0F, k) * (1 - 3e-7F);
    EXPECT_EQ(level({side, 0}, {0, side}), k);
  }
}

TEST(LevelOfDetail, IsZeroWhereAPixelIsNoLargerThanATexel) {
  EXPECT_EQ(level({1, 0}, {0, 1}), 0);
  EXPECT_EQ(level({0.01F, 0}, {0, 0.02F}), 0);
  EXPECT_EQ(level({0, 0}, {0, 0}), 0);
  EXPECT_EQ(level({1e-30F, 0}, {0, 1e-30F}), 0) << "whose square is 0";
}

TEST(LevelOfDetail, StaysOnTheMapsLevels) {
  EXPECT_EQ(level({1e6F, 0}, {0, 1e6F}, 16, 10), 10);
  EXPECT_EQ(level({1e15F, 0}, {0, 1e15F}, 16, 10), 10);
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(level({kInfinity, 0}, {0, 1}, 16, 10), 10);
  EXPECT_EQ(level({kInfinity, 0}, {0, kInfinity}, 16, 10), 10);
  EXPECT_EQ(level({1e25F, 0}, {0, 1e25F}, 16, 10), 10) << "whose square overflows";
}

// What the pixel's rotation on the screen, or that of the map, is cannot matter; nor which way an axis runs.
TEST(LevelOfDetail, DependsOnTheLengthsOfTheSidesAlone) {
  for (int i = 0; i < 360; i += 7) {
    const auto turn = static_cast<float>(i * std::numbers::pi / 180);
    const vec2 x = 5.5F * vec2(std::cos(turn), std::sin(turn));
    const vec2 y = 13.0F * vec2(std::sin(turn), -std::cos(turn));
    EXPECT_EQ(level(x, y), level({5.5F, 0}, {0, 13}));
    EXPECT_EQ(level(y, -x), level({5.5F, 0}, {0, 13}));
  }
}

// The papers' compensation: a pixel that is stretched by up to n_a,max takes the level of its shorter side.
TEST(LevelOfDetail, FollowsTheShorterSideUpToTheLargestAnisotropy) {
  for (int stretch = 1; stretch <= 16; ++stretch)
    EXPECT_EQ(level({4, 0}, {0, 4.0F * static_cast<float>(stretch)}), 2) << stretch;
  EXPECT_EQ(level({4, 0}, {0, 4 * 64}), 4) << "64 / 16 times the shorter side";
  EXPECT_EQ(level({4, 0}, {0, 4 * 64}, 1), 8) << "not compensated: the longer side's";
  EXPECT_EQ(level({0, 0}, {0, 256}), 4) << "edge on: 256 / 16";
}

TEST(LevelOfDetail, NeverFallsWhereThePixelGrows) {
  int last = 0;
  for (float side = 0.1F; side < 1e5F; side *= 1.01F) {
    const int now = level({side, 0}, {0, 3 * side});
    EXPECT_GE(now, last);
    last = now;
  }
  EXPECT_EQ(last, 14);
}

}  // namespace
}  // namespace gnomon::modules
