// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "terrain/level.h"
#include "terrain/procedural.h"
#include "testing/cpp_modules.h"

namespace {

using glm::ivec2;

gnomon::terrain::HeightMap fractal(int width, int height) {
  return gnomon::terrain::make_procedural({.kind = "fractal", .width = width, .height = height, .seed = 5})
      .value();
}

TEST(Extrema, BoundEverySampleOfTheirPatches) {
  const auto map = fractal(61, 34);
  glsl::use_map(map);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      for (int level = 1; level <= 7; ++level) {
        // The four patches around a sample.
        for (const ivec2 patch : {ivec2(column, row), ivec2(column + 1, row), ivec2(column, row + 1),
                                  ivec2(column + 1, row + 1)}) {
          EXPECT_GE(glsl::gnomon_host_extrema(patch >> level, level, 0), map.at(row, column));
        }
      }
    }
  }
}

TEST(Extrema, AreReachedByASample) {
  const auto map = fractal(32, 32);
  glsl::use_map(map);
  EXPECT_EQ(glsl::gnomon_host_extrema(ivec2(0, 0), 6, 0),
            *std::max_element(map.samples.begin(), map.samples.end()));
}

TEST(CoarserHeight, EqualsTheLevelsOfTheCpuToTheBit) {
  auto finer = fractal(37, 22);
  for (int q = 0; finer.width > 1 || finer.height > 1; ++q) {
    glsl::use_map(finer);
    const auto coarser = gnomon::terrain::level(finer, 1);
    for (int row = 0; row < coarser.height; ++row) {
      for (int column = 0; column < coarser.width; ++column) {
        ASSERT_EQ(glsl::gnomon_coarser_height(ivec2(column, row), ivec2(finer.width, finer.height), 0),
                  coarser.at(row, column))
            << "level " << q + 1;
      }
    }
    finer = coarser;
  }
}

}  // namespace
