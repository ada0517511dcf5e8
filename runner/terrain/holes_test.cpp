// SPDX-License-Identifier: MIT
#include "terrain/holes.h"

#include <gtest/gtest.h>

#include "terrain/level.h"

namespace gnomon::terrain {
namespace {

HeightMap map_of(int width, int height, std::vector<float> samples) {
  HeightMap map{.width = width, .height = height};
  map.domain_width = width;
  map.domain_height = height;
  map.samples = std::move(samples);
  map.holes = true;
  return map;
}

constexpr float kHole = kNoSample;

TEST(HasSurface, AHoleTakesTheFourPatchesAroundIt) {
  HeightMap map = map_of(5, 5, std::vector<float>(25, 3));
  map.samples[12] = kHole;  // in column 2, row 2: at (2.5, 2.5)
  EXPECT_FALSE(has_surface(map, 2.5, 2.5));
  EXPECT_FALSE(has_surface(map, 1.6, 2.0));
  EXPECT_FALSE(has_surface(map, 3.4, 3.4));
  // The border of the hole belongs to the patches around it, samples and edges alike.
  EXPECT_TRUE(has_surface(map, 1.5, 2.5));
  EXPECT_TRUE(has_surface(map, 1.5, 1.5));
  EXPECT_TRUE(has_surface(map, 3.5, 2.1));
  EXPECT_TRUE(has_surface(map, 2.5, 3.5));
  EXPECT_FALSE(has_surface(map, 2.5, 3.4999));
  EXPECT_TRUE(has_surface(map, 0, 0));
  EXPECT_TRUE(has_surface(map, 5, 5));
}

TEST(HasSurface, TheHalfPatchesAtTheEdgeEndWithTheirSample) {
  HeightMap map = map_of(3, 1, {kHole, 1, 2});
  EXPECT_FALSE(has_surface(map, 0, 0));
  EXPECT_FALSE(has_surface(map, 0.5, 0.5));
  EXPECT_FALSE(has_surface(map, 1.4, 0.5));
  EXPECT_TRUE(has_surface(map, 1.5, 0.2));
  EXPECT_TRUE(has_surface(map, 3, 1));
}

TEST(HasSurface, ASampleWithoutAWholePatchHasNone) {
  // The sample in the middle is there, its four patches are not.
  HeightMap map = map_of(3, 3, {kHole, 1, kHole, 1, 1, 1, kHole, 1, kHole});
  EXPECT_FALSE(has_surface(map, 1.5, 1.5));
  EXPECT_TRUE(has_surface(map_of(1, 1, {4}), 0.5, 0.5));
  EXPECT_FALSE(has_surface(map_of(1, 1, {kHole}), 0.5, 0.5));
}

TEST(Level, MeansAreOverTheSamplesThatAreThere) {
  const HeightMap map = map_of(5, 2, {1, kHole, kHole, kHole, 7, 3, 5, kHole, kHole, 8});
  const HeightMap coarser = level(map, 1);
  EXPECT_EQ(coarser.samples, (std::vector<float>{(1.0F + 8.0F) * (1.0F / 3.0F), kHole, 7.5F}));
  EXPECT_TRUE(coarser.holes);
  EXPECT_EQ(level(map, 2).samples, (std::vector<float>{3.0F, 7.5F}));
  EXPECT_EQ(level(map_of(2, 2, {kHole, kHole, kHole, kHole}), 1).samples, (std::vector<float>{kHole}));
}

}  // namespace
}  // namespace gnomon::terrain
