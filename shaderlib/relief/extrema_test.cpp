// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "terrain/level.h"
#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace {

using glm::ivec2;
using gnomon::modules::MapModules;

gnomon::terrain::HeightMap fractal(int width, int height) {
  return gnomon::terrain::make_procedural({.kind = "fractal", .width = width, .height = height, .seed = 5})
      .value();
}

TEST(Extrema, BoundEverySampleOfTheirPatches) {
  const auto map = fractal(61, 34);
  const MapModules modules(map);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      for (int level = 1; level <= 7; ++level) {
        // The four patches around a sample.
        for (const ivec2 patch : {ivec2(column, row), ivec2(column + 1, row), ivec2(column, row + 1),
                                  ivec2(column + 1, row + 1)}) {
          EXPECT_GE(modules.gnomon_host_extrema(patch >> level, level, 0), map.at(row, column));
        }
      }
    }
  }
}

TEST(Extrema, AreReachedByASample) {
  const auto map = fractal(32, 32);
  const MapModules modules(map);
  EXPECT_EQ(modules.gnomon_host_extrema(ivec2(0, 0), 6, 0),
            *std::max_element(map.samples.begin(), map.samples.end()));
}

TEST(Extrema, OfPatchesAreTheHighestCornerOfTheFour) {
  // One peak; the blocks that its patches belong to see it, and no other does.
  auto map = gnomon::modules::flat_map(16, 12, 1);
  map.samples[std::size_t(5 * 16 + 8)] = 9;
  const MapModules modules(map);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 9; ++x) {
      const bool has_peak = (x == 4) && (y == 2 || y == 3);
      EXPECT_EQ(modules.gnomon_extrema_of_patches(ivec2(x, y), 0), has_peak ? 9.0F : 1.0F) << x << " " << y;
    }
  }
}

TEST(Extrema, OfBlocksAreTheHighestOfTheFourBelow) {
  auto map = gnomon::modules::flat_map(16, 12, 1);
  map.samples[std::size_t(5 * 16 + 8)] = 9;
  const MapModules modules(map);
  for (int y = 0; y < 4; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(modules.gnomon_extrema_of_blocks(ivec2(x, y), 2, 0), x == 2 && y == 1 ? 9.0F : 1.0F);
    }
  }
}

void expect_levels_of_the_cpu(gnomon::terrain::HeightMap finer) {
  for (int q = 0; finer.width > 1 || finer.height > 1; ++q) {
    const MapModules modules(finer);
    const auto coarser = gnomon::terrain::level(finer, 1);
    for (int row = 0; row < coarser.height; ++row) {
      for (int column = 0; column < coarser.width; ++column) {
        ASSERT_EQ(modules.gnomon_coarser_height(ivec2(column, row), ivec2(finer.width, finer.height), 0),
                  coarser.at(row, column))
            << "level " << q + 1;
      }
    }
    finer = coarser;
  }
}

TEST(CoarserHeight, EqualsTheLevelsOfTheCpuToTheBit) {
  auto map = fractal(37, 22);
  expect_levels_of_the_cpu(map);
  // One, two, three and four children missing.
  for (std::size_t i = 0; i < map.samples.size(); i += 3) map.samples[i] = GNOMON_NO_SAMPLE;
  for (std::size_t i = 200; i < 400; ++i) map.samples[i] = GNOMON_NO_SAMPLE;
  map.holes = true;
  expect_levels_of_the_cpu(map);
}

}  // namespace
