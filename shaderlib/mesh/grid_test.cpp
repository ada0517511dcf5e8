// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "terrain/height_map.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(4, 4));

TEST(GridNodes, LieOnTheEdgesAndOnEveryStepthSampleAndOnTheLast) {
  for (const int samples : {1, 2, 5, 333}) {
    for (const int step : {1, 2, 3, 7, 400}) {
      const int nodes = kFlat.gnomon_grid_nodes(samples, step);
      const auto domain = static_cast<float>(samples);
      EXPECT_EQ(kFlat.gnomon_grid_coordinate(0, samples, domain, step), 0.0F);
      EXPECT_EQ(kFlat.gnomon_grid_coordinate(nodes - 1, samples, domain, step), domain);
      EXPECT_EQ(kFlat.gnomon_grid_coordinate(nodes - 2, samples, domain, step), domain - 0.5F);
      for (int node = 1; node < nodes - 2; ++node)
        ASSERT_EQ(kFlat.gnomon_grid_coordinate(node, samples, domain, step),
                  static_cast<float>((node - 1) * step) + 0.5F);
      for (int node = 1; node < nodes; ++node)
        ASSERT_LT(kFlat.gnomon_grid_coordinate(node - 1, samples, domain, step),
                  kFlat.gnomon_grid_coordinate(node, samples, domain, step));
    }
  }
}

TEST(GridNodes, StayInADomainThatEndsBeforeTheLastSample) {
  EXPECT_EQ(kFlat.gnomon_grid_coordinate(2, 2, 1.25F, 1), 1.25F) << "sample 1 lies at 1.5";
  EXPECT_EQ(kFlat.gnomon_grid_coordinate(3, 2, 1.25F, 1), 1.25F);
}

TEST(GridCell, HoldsItsCoordinate) {
  for (const int samples : {1, 2, 5, 33}) {
    for (const int step : {1, 2, 3, 7}) {
      const auto domain = static_cast<float>(samples);
      for (int i = 0; i <= 8 * samples; ++i) {
        const float at = static_cast<float>(i) / 8;
        const int cell = kFlat.gnomon_grid_cell(at, samples, step);
        ASSERT_GE(at, kFlat.gnomon_grid_coordinate(cell, samples, domain, step)) << samples << ' ' << step;
        ASSERT_LE(at, kFlat.gnomon_grid_coordinate(cell + 1, samples, domain, step))
            << samples << ' ' << step;
      }
    }
  }
}

terrain::HeightMap plane(int width, int height, float east, float south) {
  terrain::HeightMap map = flat_map(width, height);
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      map.samples[static_cast<std::size_t>(row * width + column)] =
          east * static_cast<float>(column) + south * static_cast<float>(row);
  return map;
}

TEST(GridHeight, IsTheSampleOnASampleAndTheSurfaceElsewhere) {
  terrain::HeightMap map = plane(5, 4, 2, 8);
  const MapModules modules(map);
  EXPECT_EQ(modules.gnomon_grid_height(2.5F, 1.5F, 0), 12.0F);
  EXPECT_EQ(modules.gnomon_grid_height(0.0F, 1.5F, 0), 8.0F) << "as high as the first sample";
  EXPECT_EQ(modules.gnomon_grid_height(5.0F, 4.0F, 0), 32.0F);
  EXPECT_EQ(modules.gnomon_grid_height(2.0F, 2.0F, 0), 15.0F) << "between samples";
  map.samples[7] = terrain::kNoSample;  // column 2, row 1
  map.holes = true;
  const MapModules with_hole(map);
  EXPECT_EQ(with_hole.gnomon_grid_height(2.5F, 1.5F, 0), GNOMON_NO_SAMPLE);
  EXPECT_EQ(with_hole.gnomon_grid_height(2.0F, 2.0F, 0), GNOMON_NO_SAMPLE);
  EXPECT_EQ(with_hole.gnomon_grid_height(1.5F, 1.5F, 0), 10.0F);
}

TEST(GridHeight, OnTheEdgeBesideAHoleIsThatOfThePatchThatHasASurface) {
  terrain::HeightMap map = plane(5, 4, 2, 8);
  map.samples[5] = terrain::kNoSample;  // column 0, row 1
  map.holes = true;
  const MapModules modules(map);
  EXPECT_EQ(modules.gnomon_grid_height(0.0F, 2.5F, 0), 16.0F) << "its southern patch is whole";
  EXPECT_EQ(modules.gnomon_grid_height(0.0F, 1.5F, 0), GNOMON_NO_SAMPLE);
}

TEST(GridPoint, OfAPlaneIsThePlaneWhateverTheStep) {
  terrain::HeightMap map = plane(12, 9, 3, -2);
  map.spacing_x = 10;
  map.spacing_y = 5;
  const MapModules modules(map);
  const vec3 normal = normalize(vec3(-3.0F / 10, -2.0F / 5, 1));
  for (const int step : {1, 2, 3, 20}) {
    for (float row = 0.5F; row < 8.5F; row += 0.25F)
      for (float column = 0.5F; column < 11.5F; column += 0.25F) {
        const auto point = modules.gnomon_grid_point(modules.map(), column, row, step, 0);
        ASSERT_NEAR(point.height, 3 * (column - 0.5F) - 2 * (row - 0.5F), 1e-4F);
        ASSERT_LT(distance(point.normal, normal), 1e-5F);
      }
  }
}

TEST(GridPoint, CutsCellsFromSouthWestToNorthEast) {
  terrain::HeightMap map = flat_map(2, 2, 0);
  map.samples = {0, 4, 4, 0};  // the diagonal is a ridge
  const MapModules modules(map);
  EXPECT_EQ(modules.gnomon_grid_point(modules.map(), 1, 1, 1, 0).height, 4.0F);
  EXPECT_EQ(modules.gnomon_grid_point(modules.map(), 0.75F, 0.75F, 1, 0).height, 2.0F);
  map.samples = {4, 0, 0, 4};  // a valley
  EXPECT_EQ(MapModules(map).gnomon_grid_point(modules.map(), 1, 1, 1, 0).height, 0.0F);
}

TEST(GridPoint, TellsWhereANodeOfItsTriangleHasNoHeight) {
  terrain::HeightMap map = flat_map(4, 4, 7);
  map.samples[5] = terrain::kNoSample;  // column 1, row 1
  map.holes = true;
  const MapModules modules(map);
  EXPECT_TRUE(modules.gnomon_grid_point(modules.map(), 1.6F, 1.6F, 1, 0).hole);
  EXPECT_FALSE(modules.gnomon_grid_point(modules.map(), 2.4F, 2.4F, 1, 0).hole)
      << "the other triangle of the cell";
}

TEST(GridPoint, LeavesOutWhatLiesBetweenItsNodes) {
  terrain::HeightMap map = flat_map(5, 5, 0);
  map.samples[6] = 100;  // column 1, row 1
  const MapModules modules(map);
  EXPECT_EQ(modules.gnomon_grid_point(modules.map(), 1.5F, 1.5F, 1, 0).height, 100.0F);
  EXPECT_EQ(modules.gnomon_grid_point(modules.map(), 1.5F, 1.5F, 2, 0).height, 0.0F);
}

}  // namespace
}  // namespace gnomon::modules
