// SPDX-License-Identifier: MIT
#include "image/hillshade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace gnomon::image {
namespace {

constexpr int kSize = 33;

int brightness(const Picture& picture, int row, int column) {
  const auto first = 3 * static_cast<std::size_t>(row * picture.width + column);
  return picture.rgb[first] + picture.rgb[first + 1] + picture.rgb[first + 2];
}

/// A round hill in the middle of the map.
std::vector<float> hill() {
  std::vector<float> heights;
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column)
      heights.push_back(
          std::max(0.0f, 10.0f - std::hypot(static_cast<float>(row - 16), static_cast<float>(column - 16))));
  return heights;
}

std::vector<float> all(float value) {
  return std::vector<float>(kSize * kSize, value);
}

TEST(Hillshade, TheSideTowardsTheSunIsBrighter) {
  struct Case {
    double azimuth;
    int row, column, opposite_row, opposite_column;
  };
  for (const Case& c : {Case{0, 10, 16, 22, 16}, Case{90, 16, 22, 16, 10}, Case{180, 22, 16, 10, 16},
                        Case{270, 16, 10, 16, 22}, Case{315, 12, 12, 20, 20}}) {
    const Picture picture = hillshade(hill(), kSize, kSize, 1, 1, all(1), c.azimuth, 45);
    EXPECT_GT(brightness(picture, c.row, c.column),
              brightness(picture, c.opposite_row, c.opposite_column) + 60)
        << "azimuth " << c.azimuth;
  }
}

TEST(Hillshade, ShadowsAreClearlyDarkerAndBluer) {
  std::vector<float> k_shadow = all(1);
  for (int column = 0; column < kSize; ++column) k_shadow[static_cast<std::size_t>(column)] = 0.3f;
  const Picture picture = hillshade(all(100), kSize, kSize, 1, 1, k_shadow, 315, 10);
  EXPECT_LT(brightness(picture, 0, 5), 0.7 * brightness(picture, 1, 5));
  const auto blue_to_red = [&](int row) {
    const auto first = 3 * static_cast<std::size_t>(row * kSize + 5);
    return static_cast<double>(picture.rgb[first + 2]) / picture.rgb[first];
  };
  EXPECT_GT(blue_to_red(0), blue_to_red(1));
}

TEST(Hillshade, MapsOfOneSampleHaveAPicture) {
  EXPECT_EQ(hillshade({5}, 1, 1, 1, 1, {1}, 0, 90).rgb.size(), 3u);
  EXPECT_EQ(hillshade({5, 7}, 1, 2, 1, 1, {1, 0}, 0, -20).rgb.size(), 6u);
}

TEST(Hillshade, HolesAreGreyAndLeaveTheRestAsItIs) {
  std::vector<float> heights = hill();
  const Picture whole = hillshade(heights, kSize, kSize, 1, 1, all(1), 315, 45);
  heights[static_cast<std::size_t>(3 * kSize + 3)] = std::numeric_limits<float>::quiet_NaN();
  const Picture pierced = hillshade(heights, kSize, kSize, 1, 1, all(1), 315, 45);
  for (int row = 0; row < kSize; ++row)
    for (int column = 0; column < kSize; ++column) {
      const bool is_hole = row == 3 && column == 3;
      EXPECT_EQ(brightness(pierced, row, column) == brightness(whole, row, column), !is_hole)
          << row << ' ' << column;
    }
  EXPECT_LT(brightness(pierced, 3, 3), 250);
  const std::vector<float> nothing(heights.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_EQ(hillshade(nothing, kSize, kSize, 1, 1, all(1), 315, 45).rgb.size(), 3 * heights.size());
}

}  // namespace
}  // namespace gnomon::image
