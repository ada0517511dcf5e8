// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(8, 8));

TEST(SurfaceNormal, PointsUpFromFlatGroundAndLeansDownAPlane) {
  EXPECT_EQ(kFlat.gnomon_surface_normal(kFlat.map(), kFlat.gnomon_receiver_at(3.2F, 4.1F, 0), 0),
            vec3(0, 0, 1));
  // Rises 2 m a metre eastward, and 1 m a metre northward (row 0 lies in the north).
  terrain::HeightMap map = flat_map(8, 8);
  for (int row = 0; row < 8; ++row) {
    for (int column = 0; column < 8; ++column)
      map.samples[std::size_t(row * 8 + column)] = static_cast<float>(2 * column - row);
  }
  const MapModules plane(map);
  const vec3 normal = plane.gnomon_surface_normal(plane.map(), plane.gnomon_receiver_at(3.2F, 4.1F, 0), 0);
  const vec3 expected = normalize(vec3(-2, -1, 1));
  EXPECT_NEAR(normal.x, expected.x, 1e-6);
  EXPECT_NEAR(normal.y, expected.y, 1e-6);
  EXPECT_NEAR(normal.z, expected.z, 1e-6);
}

TEST(Lit, FollowsTheCosineAndTheShadow) {
  const vec3 up(0, 0, 1);
  const vec3 albedo(0.5F, 0.25F, 1);
  EXPECT_EQ(kFlat.gnomon_lit(albedo, up, up, 1, 0), albedo);
  const vec3 slanted(0, std::sqrt(0.75F), 0.5F);  // 30 degrees high
  EXPECT_EQ(kFlat.gnomon_lit(albedo, up, slanted, 1, 0), albedo * 0.5F);
  EXPECT_EQ(kFlat.gnomon_lit(albedo, up, slanted, 0.5F, 0), albedo * 0.25F);
  EXPECT_EQ(kFlat.gnomon_lit(albedo, up, -up, 1, 0), vec3(0)) << "faces away";
  EXPECT_EQ(kFlat.gnomon_lit(albedo, up, -up, 1, 0.25F), albedo * 0.25F) << "light from everywhere";
}

}  // namespace
}  // namespace gnomon::modules
