// SPDX-License-Identifier: MIT
#include "terrain/level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "terrain/procedural.h"

namespace gnomon::terrain {
namespace {

HeightMap map_of(int width, int height, std::vector<float> samples) {
  HeightMap map;
  map.width = width;
  map.height = height;
  map.domain_width = width;
  map.domain_height = height;
  map.samples = std::move(samples);
  return map;
}

HeightMap fractal_of(int width, int height) {
  return *make_procedural({.kind = "fractal", .width = width, .height = height, .seed = 5, .parameters = {}});
}

double mean(const HeightMap& map) {
  return std::accumulate(map.samples.begin(), map.samples.end(), 0.0) /
         static_cast<double>(map.samples.size());
}

TEST(CoarsestLevel, IsTheBinaryLogarithmOfTheLongerSideRoundedUp) {
  EXPECT_EQ(coarsest_level(1, 1), 0);
  EXPECT_EQ(coarsest_level(2, 1), 1);
  EXPECT_EQ(coarsest_level(1, 3), 2);
  EXPECT_EQ(coarsest_level(256, 256), 8);
  EXPECT_EQ(coarsest_level(257, 12), 9);
  EXPECT_EQ(coarsest_level(333, 700), 10);
  EXPECT_EQ(coarsest_level(16384, 1), 14);
}

TEST(Level, SizesAreRoundedUpAndTheCoarsestHasOneSample) {
  const HeightMap base = fractal_of(33, 70);
  const HeightMap second = level(base, 2);
  EXPECT_EQ(second.width, 9);
  EXPECT_EQ(second.height, 18);
  const HeightMap top = level(base, coarsest_level(33, 70));
  EXPECT_EQ(top.samples.size(), 1u);
}

TEST(Level, TheDomainStaysWhereItIs) {
  const HeightMap base = *make_procedural(
      {.kind = "flat", .width = 33, .height = 70, .spacing_x = 30, .spacing_y = 20, .parameters = {}});
  for (int q = 0; q <= coarsest_level(33, 70); ++q) {
    const HeightMap h = level(base, q);
    EXPECT_EQ(h.spacing_x, 30 * std::exp2(q));
    EXPECT_EQ(h.domain_width * h.spacing_x, 33 * 30.0);
    EXPECT_EQ(h.domain_height * h.spacing_y, 70 * 20.0);
    EXPECT_GE(h.width, h.domain_width);
  }
}

TEST(Level, ASampleIsTheMeanOfTheChildrenThatExist) {
  const HeightMap next = level(map_of(3, 3, {1, 2, 10, 3, 4, 20, 100, 300, 7}), 1);
  EXPECT_EQ(next.samples, (std::vector<float>{2.5f, 15.0f, 200.0f, 7.0f}));
}

TEST(Level, SumsRowsFirstInSinglePrecision) {
  // (NW + NE) loses the 1 next to 2^24; any other order, or double, would not.
  const HeightMap next = level(map_of(2, 2, {16777216.0f, 1.0f, 0.0f, 1.0f}), 1);
  EXPECT_EQ(next.samples[0], ((16777216.0f + 1.0f) + (0.0f + 1.0f)) * 0.25f);
  EXPECT_NE(next.samples[0], static_cast<float>(16777218.0 / 4));
}

TEST(Level, KeepsTheMeanOfMapsThatHalveEvenly) {
  const HeightMap base = fractal_of(128, 64);
  for (int q = 1; q <= 6; ++q) EXPECT_NEAR(mean(level(base, q)), mean(base), 1e-5) << "level " << q;
}

TEST(Level, StaysBetweenTheExtremesOfTheBase) {
  const HeightMap base = fractal_of(33, 70);
  const auto [lowest, highest] = std::minmax_element(base.samples.begin(), base.samples.end());
  for (int q = 0; q <= 7; ++q)
    for (const float h : level(base, q).samples) {
      EXPECT_GE(h, *lowest);
      EXPECT_LE(h, *highest);
    }
}

TEST(Level, OfTheHighestHeightsIsFinite) {
  const auto high = static_cast<float>(kHighestHeight);
  EXPECT_TRUE(std::isfinite(level(map_of(2, 2, {high, high, high, high}), 1).samples[0]));
}

}  // namespace
}  // namespace gnomon::terrain
