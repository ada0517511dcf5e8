// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

terrain::HeightMap one_texel(int column, int row) {
  terrain::HeightMap map = flat_map(16, 16, 0);
  map.samples[static_cast<std::size_t>(row * 16 + column)] = 1;
  return map;
}

TEST(CornerHeight, IsTheMeanOfTheFourTexelsAroundIt) {
  terrain::HeightMap map = flat_map(2, 2, 0);
  map.samples = {1, 2, 4, 8};
  const MapModules modules(map);
  EXPECT_EQ(modules.gnomon_corner_height(ivec2(1, 1)), 15.0F / 4);
  EXPECT_EQ(modules.gnomon_corner_height(ivec2(0, 0)), 1) << "clamped to the edge";
  EXPECT_EQ(modules.gnomon_corner_height(ivec2(2, 1)), (2.0F + 8) / 2);
}

TEST(WiderExtrema, HoldsBoth) {
  const MapModules modules(flat_map(2, 2));
  EXPECT_EQ(modules.gnomon_wider_extrema(vec2(3, 1), vec2(4, 2)), vec2(4, 1));
}

// Erratum a: what the papers store is no bound. The peak of 1 has a corner value of 0.25.
TEST(LiteralExtrema, OfTexelsLoseAPeakOfOneTexel) {
  const MapModules modules(one_texel(9, 4));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_texels(ivec2(4, 2)), vec2(0.25F, 0));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_texels(ivec2(3, 2)), vec2(0, 0));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_texels(ivec2(5, 2)), vec2(0.25F, 0)) << "its west edge";
  EXPECT_EQ(modules.gnomon_literal_extrema_of_texels(ivec2(4, 1)), vec2(0.25F, 0)) << "its south edge";
}

TEST(LiteralExtrema, OfBlocksAreThoseOfTheFourBelow) {
  const MapModules modules(one_texel(9, 4));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_blocks(ivec2(2, 1), 2), vec2(0.25F, 0));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_blocks(ivec2(1, 1), 2), vec2(0, 0));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_blocks(ivec2(1, 0), 3), vec2(0.25F, 0));
  EXPECT_EQ(modules.gnomon_literal_extrema_of_blocks(ivec2(1, 1), 3), vec2(0, 0));
}

TEST(LiteralExtrema, EndOneLevelBeforeTheSingleBlock) {
  EXPECT_EQ(MapModules(flat_map(16, 16)).literal_top_level(), 3) << "of 2 x 2 blocks";
  EXPECT_EQ(MapModules(flat_map(17, 3)).literal_top_level(), 4) << "of 2 x 1 blocks";
  EXPECT_EQ(MapModules(flat_map(2, 2)).literal_top_level(), 0);
  EXPECT_EQ(MapModules(flat_map(1, 1)).literal_top_level(), 0);
}

// They lie between the true extrema of the block and its neighbours, whatever the size.
TEST(LiteralExtrema, AreHeightsOfTheSurface) {
  for (const auto& [width, height] : {std::pair{61, 34}, {64, 64}, {5, 90}}) {
    const auto map =
        terrain::make_procedural({.kind = "fractal", .width = width, .height = height, .seed = 2}).value();
    const MapModules modules(map);
    const auto [lowest, highest] = std::ranges::minmax(map.samples);
    for (int level = 1; level <= modules.literal_top_level(); ++level) {
      for (int y = 0; y << level < height; ++y) {
        for (int x = 0; x << level < width; ++x) {
          const vec2 extrema = modules.gnomon_host_literal_extrema(ivec2(x, y), level);
          EXPECT_LE(extrema.x, highest);
          EXPECT_GE(extrema.y, lowest);
          EXPECT_GE(extrema.x, modules.gnomon_corner_height(ivec2(x, y) << level));
          EXPECT_LE(extrema.y, modules.gnomon_corner_height(ivec2(x, y) << level));
        }
      }
    }
  }
}

}  // namespace
}  // namespace gnomon::modules
