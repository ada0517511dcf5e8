// SPDX-License-Identifier: MIT
#include "technique/height_ranges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "terrain/height_map.h"

namespace gnomon::technique {
namespace {

std::size_t index(int x, int y, int width) {
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

TEST(HeightRanges, HoldEverySampleOfARectangle) {
  std::mt19937 random(5);
  const glm::ivec2 size(150, 77);
  std::vector<float> samples(index(0, size.y, size.x));
  for (float& sample : samples) sample = static_cast<float>(random() % 1000);
  const HeightRanges ranges(samples, size);
  const auto any = [&](int below) { return static_cast<int>(random() % static_cast<unsigned>(below)); };
  for (int i = 0; i < 500; ++i) {
    const glm::ivec2 a(any(size.x), any(size.y)), b(any(size.x), any(size.y));
    const glm::ivec2 first = glm::min(a, b), last = glm::max(a, b);
    const auto range = ranges.over(first, last);
    ASSERT_TRUE(range.has_value());
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        ASSERT_LE(range->low, samples[index(x, y, size.x)]);
        ASSERT_GE(range->high, samples[index(x, y, size.x)]);
      }
    }
  }
}

TEST(HeightRanges, AreNoWiderThanTheBlocksThatTheyTouch) {
  std::vector<float> samples(index(0, 100, 100), 5.0F);
  samples[index(99, 99, 100)] = 900;
  const HeightRanges ranges(samples, {100, 100});
  EXPECT_EQ(ranges.over({0, 0}, {50, 50})->high, 5);
  EXPECT_EQ(ranges.over({0, 0}, {99, 99})->high, 900);
  EXPECT_EQ(ranges.over({-20, -1}, {-3, 0})->high, 5) << "beside the map: its edge";
  EXPECT_EQ(ranges.over({99, 99}, {140, 130})->high, 900);
}

TEST(HeightRanges, LeaveOutSamplesWithoutData) {
  std::vector<float> samples(index(0, 64, 64), terrain::kNoSample);
  samples[index(40, 3, 64)] = 7;
  const HeightRanges ranges(samples, {64, 64});
  EXPECT_FALSE(ranges.over({0, 0}, {20, 20}).has_value());
  EXPECT_EQ(ranges.over({0, 0}, {63, 63})->low, 7);
}

}  // namespace
}  // namespace gnomon::technique
