// SPDX-License-Identifier: MIT
// Rays over maps with holes, against the double-precision oracle: on samples, on the edges of holes, between,
// along edges and diagonals; each also just above and below its own horizon.
#include "terrain/holes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "oracle/oracle.h"
#include "terrain/level.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

class Rays {
 public:
  Rays(const terrain::HeightMap& map, unsigned seed) : map_(map), modules_(map), random_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) * 0x1p-32;
  }

  /// Asks until `count` receivers with a surface have been asked; each at four elevations.
  void ask(int count) {
    const oracle::Surface surface{map_.width,        map_.height,        map_.spacing_x, map_.spacing_y,
                                  map_.domain_width, map_.domain_height, map_.samples};
    for (int i = 0; i < count;) {
      const bool on_samples = random_() % 2 == 0;
      const auto column = static_cast<float>(place(map_.width, map_.domain_width, on_samples));
      const auto row =
          static_cast<float>(place(map_.height, map_.domain_height, on_samples || random_() % 3 == 0));
      const float height = random_() % 4 == 0 ? 2.5F : 0.0F;
      const bool valid = terrain::has_surface(map_, column, row);
      ASSERT_EQ(valid, oracle::has_surface(surface, column, row)) << column << ' ' << row;
      ASSERT_EQ(valid, modules_.gnomon_has_surface(modules_.gnomon_receiver_at(column, row, height), 0));
      if (!valid) continue;
      ++i;
      const double azimuth = random_() % 2 == 0 ? 45.0 * static_cast<double>(random_() % 8) : uniform(0, 360);
      const auto sun = oracle::ground_direction(azimuth);
      const double horizon = std::atan(oracle::horizon_slope(surface, {column, row, height}, sun));
      for (const double elevation :
           {horizon - 1.2e-4, horizon + 1.2e-4, uniform(0.001, 0.4), uniform(0.4, 1.5)}) {
        if (elevation <= 1e-6 || elevation >= 1.57 || std::abs(elevation - horizon) < 1e-4) continue;
        const bool expected = horizon > elevation;
        const vec3 to_sun(sun.east * std::cos(elevation), sun.north * std::cos(elevation),
                          std::sin(elevation));
        const auto receiver = modules_.gnomon_receiver_at(column, row, height);
        const auto quick =
            modules_.gnomon_multilevel(modules_.map(), receiver, to_sun, 0, modules_.step_limit());
        const auto slow =
            modules_.gnomon_brute_force(modules_.map(), receiver, to_sun, 0, modules_.step_limit());
        ASSERT_NE(quick.cause, GNOMON_CAUSE_UNDECIDED);
        ++rays;
        shadows += expected ? 1 : 0;
        if ((quick.shadow > 0) == expected && (slow.shadow > 0) == expected) continue;
        ++wrong;
        if (wrong > 5) continue;
        ADD_FAILURE() << "(" << column << ", " << row << ") +" << height << " towards " << azimuth
                      << ": horizon " << horizon << ", elevation " << elevation << ", multilevel "
                      << quick.shadow << ", brute force " << slow.shadow;
      }
    }
  }

  int rays = 0, shadows = 0, wrong = 0;

 private:
  double place(int samples, double domain, bool on_sample) {
    if (on_sample)
      return std::min(static_cast<double>(random_() % static_cast<unsigned>(samples)) + 0.5, domain);
    return uniform(0, domain);
  }

  const terrain::HeightMap& map_;
  MapModules modules_;
  std::mt19937 random_;
};

enum class Ground { kNoise, kHills, kSpikes };

terrain::HeightMap ground(Ground kind, int width, int height, std::mt19937& random) {
  terrain::HeightMap map = flat_map(width, height);
  map.spacing_x = 10;
  // Square, where a diagonal passes exactly through corners; else so that none passes nearly through one:
  // there single precision may see the corner of a patch or miss it, whatever the elevation.
  map.spacing_y = kind == Ground::kHills ? 10 : 14.137;
  for (int i = 0; i < width * height; ++i) {
    const double x = i % width, y = i / width;  // NOLINT: whole rows
    const double noise = static_cast<double>(random()) * 0x1p-32;
    map.samples[static_cast<std::size_t>(i)] = static_cast<float>(
        kind == Ground::kNoise   ? 4000 + 30 * noise
        : kind == Ground::kHills ? 300 + 40 * std::sin(0.35 * x) * std::cos(0.3 * y) + 2 * noise
                                 : (noise < 0.03 ? 200 : 3 * noise));
  }
  return map;
}

/// Single samples, and blocks of them.
void pierce(terrain::HeightMap& map, double share, std::mt19937& random) {
  map.holes = true;
  const auto size = map.samples.size();
  for (std::size_t i = 0; i < size; ++i) {
    if (static_cast<double>(random()) * 0x1p-32 >= share) continue;
    const int side = random() % 4 == 0 ? 5 : 1;
    const int column = static_cast<int>(i) % map.width, row = static_cast<int>(i) / map.width;
    for (int y = row; y < std::min(row + side, map.height); ++y)
      for (int x = column; x < std::min(column + side, map.width); ++x)
        map.samples[static_cast<std::size_t>(y * map.width + x)] = terrain::kNoSample;
  }
}

TEST(Holes, NoRayDiffersFromTheOracle) {
  std::mt19937 random(1);
  int rays = 0, shadows = 0;
  unsigned seed = 10;
  for (const Ground kind : {Ground::kNoise, Ground::kHills, Ground::kSpikes}) {
    for (const double share : {0.003, 0.03, 0.15}) {
      terrain::HeightMap map = ground(kind, 61, 47, random);
      pierce(map, share, random);
      Rays at(map, ++seed);
      at.ask(4000);
      EXPECT_EQ(at.wrong, 0) << "of " << at.rays;
      rays += at.rays;
      shadows += at.shadows;
    }
  }
  RecordProperty("rays", rays);
  std::cout << rays << " rays, " << shadows << " in shadow\n";
  EXPECT_GT(rays, 80000);
  EXPECT_GT(shadows, 15000);
}

TEST(Holes, NorOnCoarserLevels) {
  std::mt19937 random(2);
  for (int q = 1; q <= 3; ++q) {
    terrain::HeightMap map = ground(Ground::kHills, 131, 93, random);
    pierce(map, 0.05, random);
    const terrain::HeightMap coarser = terrain::level(map, q);
    Rays at(coarser, static_cast<unsigned>(q));
    at.ask(3000);
    EXPECT_EQ(at.wrong, 0) << "of " << at.rays << " at level " << q;
  }
}

TEST(Holes, WithoutAnyTheMapIsOneOfBefore) {
  std::mt19937 random(3);
  terrain::HeightMap map = ground(Ground::kNoise, 61, 47, random);
  Rays at(map, 4);
  at.ask(3000);
  EXPECT_EQ(at.wrong, 0);
}

}  // namespace
}  // namespace gnomon::modules
