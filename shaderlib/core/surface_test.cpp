// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <random>

#include "terrain/holes.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

terrain::HeightMap with_holes(int width, int height, double share, unsigned seed) {
  terrain::HeightMap map = flat_map(width, height);
  std::mt19937 random(seed);
  for (float& sample : map.samples)
    if (static_cast<double>(random()) < share * 0x1p32) sample = terrain::kNoSample;
  map.holes = true;
  return map;
}

TEST(PatchHasSurface, NeedsItsFourCorners) {
  terrain::HeightMap map = flat_map(4, 4);
  map.samples[5] = terrain::kNoSample;  // column 1, row 1
  const MapModules modules(map);
  int whole = 0;
  for (int y = 0; y <= 4; ++y)
    for (int x = 0; x <= 4; ++x) whole += modules.gnomon_patch_has_surface(ivec2(x, y), 0) ? 1 : 0;
  EXPECT_EQ(whole, 25 - 4);
  for (const ivec2 patch : {ivec2(1, 1), ivec2(2, 1), ivec2(1, 2), ivec2(2, 2)})
    EXPECT_FALSE(modules.gnomon_patch_has_surface(patch, 0));
}

TEST(HasSurface, AgreesWithTheMapOnSamplesEdgesAndBetween) {
  for (const double share : {0.02, 0.2, 0.6}) {
    const terrain::HeightMap map = with_holes(23, 17, share, 3);
    const MapModules modules(map);
    for (int i = 0; i <= 8 * map.height; ++i)
      for (int j = 0; j <= 8 * map.width; ++j) {
        const float column = static_cast<float>(j) / 8, row = static_cast<float>(i) / 8;
        const auto receiver = modules.gnomon_receiver_at(column, row, 0);
        ASSERT_EQ(modules.gnomon_has_surface(receiver, 0), terrain::has_surface(map, column, row))
            << column << ' ' << row;
      }
  }
}

TEST(HasSurface, TheFarEdgeOfAPatchBelongsToItsNeighboursToo) {
  terrain::HeightMap map = flat_map(4, 4);
  map.samples[5] = terrain::kNoSample;
  const MapModules modules(map);
  Modules::GnomonReceiver receiver{.patch_index = ivec2(2, 2), .fraction = vec2(0.5F, 0.5F), .height = 0};
  EXPECT_FALSE(modules.gnomon_has_surface(receiver, 0));
  receiver.fraction = vec2(1, 0.5F);
  EXPECT_TRUE(modules.gnomon_has_surface(receiver, 0));
  const auto moved = modules.gnomon_on_surface(receiver, 0);
  EXPECT_EQ(moved.patch_index, ivec2(3, 2));
  EXPECT_EQ(moved.fraction, vec2(0, 0.5F));
  receiver.fraction = vec2(0.5F, 1);
  EXPECT_TRUE(modules.gnomon_has_surface(receiver, 0));
}

}  // namespace
}  // namespace gnomon::modules
