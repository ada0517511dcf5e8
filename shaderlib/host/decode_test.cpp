// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(4, 4));

TEST(Decode, NormalisedChannelsGiveTheirIntegerBack) {
  for (int stored = 0; stored <= 0xFFFF; ++stored) {
    const float channel = static_cast<float>(stored) / 65535.0F;
    ASSERT_EQ(kFlat.gnomon_stored_number(channel, 65535.0F), stored);
    // A driver may be off by one unit in the last place.
    ASSERT_EQ(kFlat.gnomon_stored_number(std::nextafter(channel, 2.0F), 65535.0F), stored);
    ASSERT_EQ(kFlat.gnomon_stored_number(std::nextafter(channel, -1.0F), 65535.0F), stored);
  }
  EXPECT_EQ(kFlat.gnomon_stored_rgb(1.0F, 0.0F, 128.0F / 255.0F), 0xFF0080);
}

TEST(Decode, TerrainRgbIsRoundedOnceHoweverAGpuDivides) {
  for (int stored = 0; stored <= 0xFFFFFF; ++stored) {
    const int decimetres = stored - 100000;
    const float expected = static_cast<float>(decimetres) / 10.0F;  // IEEE 754: rounded once
    float above = expected;
    float below = expected;
    for (int units = 0; units <= 3; ++units) {
      ASSERT_EQ(kFlat.gnomon_exact_tenth(decimetres, above), expected) << stored << " + " << units;
      ASSERT_EQ(kFlat.gnomon_exact_tenth(decimetres, below), expected) << stored << " - " << units;
      above = std::nextafter(above, 1e9F);
      below = std::nextafter(below, -1e9F);
    }
  }
}

TEST(Decode, KnownHeights) {
  EXPECT_EQ(kFlat.gnomon_terrain_rgb_height(0), -10000.0F);
  EXPECT_EQ(kFlat.gnomon_terrain_rgb_height(100000), 0.0F);
  EXPECT_EQ(kFlat.gnomon_terrain_rgb_height(188488), 8848.8F);
  EXPECT_EQ(kFlat.gnomon_terrarium_height(0), -32768.0F);
  EXPECT_EQ(kFlat.gnomon_terrarium_height(0x800000), 0.0F);
  EXPECT_EQ(kFlat.gnomon_terrarium_height(0xFFFFFF), 32768.0F - 1.0F / 256.0F);
  EXPECT_EQ(kFlat.gnomon_scaled_height(8000, 0.125F, -431.25F), 568.75F);
}

}  // namespace
}  // namespace gnomon::modules
