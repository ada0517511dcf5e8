// SPDX-License-Identifier: MIT
// The exact methods as C++, against the double-precision oracle.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "oracle/oracle.h"
#include "technique/surface.h"
#include "terrain/level.h"
#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace {

using glm::ivec2;
using glm::vec3;
using gnomon::modules::MapModules;
using gnomon::technique::surface_of;
using gnomon::terrain::HeightMap;
namespace oracle = gnomon::oracle;

struct Asked {
  float column, row;
  double elevation;  // degrees
};

/// Rays that share an azimuth and a receiver height, so that the oracle answers them together.
struct Batch {
  double azimuth = 0;  // degrees
  float height = 0;    // metres above the ground
  bool on_samples = false;
  std::vector<Asked> rays;
  std::vector<double> horizons;  // radians
  double band = 0;               // radians
};

HeightMap make(const std::string& kind, int width, int height) {
  return gnomon::terrain::make_procedural(
             {.kind = kind, .width = width, .height = height, .seed = 3, .spacing_x = 10, .spacing_y = 10})
      .value();
}

vec3 to_sun(double azimuth, double elevation) {
  const auto ground = oracle::ground_direction(azimuth);
  const double angle = elevation * std::numbers::pi / 180;
  return vec3(ground.east * std::cos(angle), ground.north * std::cos(angle), std::sin(angle));
}

double azimuth_of(int number, double random) {
  if (number % 5 == 0) return 90.0 * std::floor(4 * random);
  if (number % 5 == 1) return 45.0 + 90.0 * std::floor(4 * random);
  return 360.0 * random;
}

/// Batch `number` of a map: azimuths on axes, on diagonals and odd ones, receivers at 0, 0.5 and 50 m, on
/// samples and between them.
Batch make_batch(const HeightMap& map, double steepest, int number, int rays) {
  std::mt19937 random(static_cast<unsigned>(1000 + number));
  std::uniform_real_distribution<double> unit(0, 1);
  Batch batch{.azimuth = azimuth_of(number, unit(random)),
              .height = std::array{0.0F, 0.5F, 50.0F}[static_cast<std::size_t>(number / 5 % 3)],
              .on_samples = number % 2 == 0 && map.domain_width == map.width};
  std::vector<oracle::Receiver> receivers;
  for (int i = 0; i < rays; ++i) {
    Asked asked{static_cast<float>(unit(random) * map.domain_width),
                static_cast<float>(unit(random) * map.domain_height), 0.1 + 89.8 * std::pow(unit(random), 3)};
    if (batch.on_samples) {
      asked.column = std::floor(std::min(asked.column, static_cast<float>(map.width - 1))) + 0.5F;
      asked.row = std::floor(std::min(asked.row, static_cast<float>(map.height - 1))) + 0.5F;
    }
    batch.rays.push_back(asked);
    receivers.push_back({asked.column, asked.row, batch.height});
  }
  batch.horizons = oracle::horizons(surface_of(map), receivers, oracle::ground_direction(batch.azimuth));
  batch.band = oracle::band_width(batch.on_samples, batch.height, steepest);
  return batch;
}

struct Tally {
  int rays = 0, in_band = 0, wrong = 0, undecided = 0;
};

void ask(const MapModules& modules, const Batch& batch, const Asked& asked, double horizon, Tally& tally) {
  const auto receiver = modules.gnomon_receiver_at(asked.column, asked.row, batch.height);
  const vec3 sun = to_sun(batch.azimuth, asked.elevation);
  const auto map = modules.map();
  const auto answer = modules.gnomon_multilevel(map, receiver, sun, 0, modules.step_limit());
  const auto brute = modules.gnomon_brute_force(map, receiver, sun, 0, modules.step_limit());
  tally.rays += 1;
  tally.undecided += answer.cause == GNOMON_CAUSE_UNDECIDED || brute.cause == GNOMON_CAUSE_UNDECIDED;
  if (oracle::in_band(horizon, asked.elevation, batch.band)) {
    tally.in_band += 1;
    return;
  }
  const bool expected = oracle::in_shadow(horizon, asked.elevation);
  if ((answer.shadow > 0.5F) == expected && (brute.shadow > 0.5F) == expected) return;
  if (++tally.wrong <= 3) {
    ADD_FAILURE() << map.size.x << " x " << map.size.y << " at (" << asked.column << ", " << asked.row
                  << ") + " << batch.height << " m, azimuth " << batch.azimuth << ", elevation "
                  << asked.elevation << ", horizon " << horizon * 180 / std::numbers::pi << ": expected "
                  << expected << ", multilevel " << answer.shadow << ", brute force " << brute.shadow;
  }
}

class ExactShadow : public testing::TestWithParam<const char*> {};

TEST_P(ExactShadow, AgreesWithTheOracleOutsideTheBandAtEveryLevel) {
  Tally tally;
  const HeightMap base = make(GetParam(), 133, 70);
  for (int q = 0; q <= gnomon::terrain::coarsest_level(base.width, base.height); ++q) {
    const HeightMap map = gnomon::terrain::level(base, q);
    const MapModules modules(map);
    const double steepest = oracle::steepest_slope(surface_of(map));
    for (int number = 0; number < 30; ++number) {
      const Batch batch = make_batch(map, steepest, number, 200);
      for (std::size_t i = 0; i < batch.rays.size(); ++i) {
        ask(modules, batch, batch.rays[i], batch.horizons[i], tally);
      }
    }
  }
  std::cout << GetParam() << ": " << tally.rays << " rays, " << tally.wrong << " mismatches, "
            << tally.in_band << " in band\n";
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_EQ(tally.undecided, 0);
  EXPECT_LT(tally.in_band, tally.rays / 20);
}

// A thousand times as sharp as random suns: each ray asks at its own horizon, half a percent beyond the band.
TEST_P(ExactShadow, IsOnTheRightSideOfItsOwnHorizon) {
  Tally tally;
  const HeightMap map = make(GetParam(), 333, 700);
  const MapModules modules(map);
  const double steepest = oracle::steepest_slope(surface_of(map));
  for (int number = 0; tally.rays < 100000 && number < 2000; ++number) {
    const Batch batch = make_batch(map, steepest, number, 500);
    for (std::size_t i = 0; i < batch.rays.size(); ++i) {
      for (const double side : {-1.005, 1.005}) {
        Asked asked = batch.rays[i];
        asked.elevation = (batch.horizons[i] + side * batch.band) * 180 / std::numbers::pi;
        if (asked.elevation > 0 && asked.elevation < 90) ask(modules, batch, asked, batch.horizons[i], tally);
      }
    }
  }
  std::cout << GetParam() << " at its own horizon: " << tally.rays << " rays, " << tally.wrong
            << " on the wrong side\n";
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_EQ(tally.in_band, 0);
  EXPECT_GE(tally.rays, 100000);
}

INSTANTIATE_TEST_SUITE_P(Maps, ExactShadow,
                         testing::Values("fractal", "gorge", "spikes", "steps", "posts", "crater"),
                         [](const auto& info) { return std::string(info.param); });

// A ray along the edge of the domain looks at the surface there; one that faces out meets nothing.
TEST(Multilevel, AgreesWithTheOracleOnEveryEdgeAndCorner) {
  Tally tally;
  const HeightMap base = make("fractal", 61, 34);
  for (int q = 0; q <= gnomon::terrain::coarsest_level(base.width, base.height); ++q) {
    const HeightMap map = gnomon::terrain::level(base, q);
    const MapModules modules(map);
    const auto east = static_cast<float>(map.domain_width);
    const auto south = static_cast<float>(map.domain_height);
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
      Batch batch{.azimuth = double(azimuth), .band = 1e-4};
      std::vector<oracle::Receiver> receivers;
      for (int i = 0; i <= 8; ++i) {
        const float part = static_cast<float>(i) / 8;
        for (const auto& [column, row] : {std::pair{0.0F, part * south},
                                          {east, part * south},
                                          {part * east, 0.0F},
                                          {part * east, south}}) {
          batch.rays.push_back({column, row, 3});
          receivers.push_back({column, row, 0});
        }
      }
      batch.horizons = oracle::horizons(surface_of(map), receivers, oracle::ground_direction(azimuth));
      for (std::size_t i = 0; i < batch.rays.size(); ++i) {
        for (const double elevation : {0.5, 3.0, 9.0}) {
          ask(modules, batch, {batch.rays[i].column, batch.rays[i].row, elevation}, batch.horizons[i], tally);
        }
      }
    }
  }
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_EQ(tally.undecided, 0);
  EXPECT_GT(tally.rays, 10000);
}

TEST(Multilevel, EndsOnDegenerateMapsAndSuns) {
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 5}}) {
    const MapModules modules(gnomon::modules::flat_map(width, height));
    for (int azimuth = 0; azimuth < 360; azimuth += 15) {
      for (const double elevation : {0.0, 1e-4, 45.0, 89.9999, 90.0}) {
        for (float column = 0; column <= static_cast<float>(width); column += 0.5F) {
          const auto receiver = modules.gnomon_receiver_at(column, 0.5F * static_cast<float>(height), 0);
          const auto answer = modules.gnomon_multilevel(modules.map(), receiver, to_sun(azimuth, elevation),
                                                        0, modules.step_limit());
          EXPECT_NE(answer.cause, GNOMON_CAUSE_UNDECIDED);
          EXPECT_EQ(answer.shadow, elevation <= 0 ? 1.0F : 0.0F);
        }
      }
    }
  }
}

TEST(FarWalk, GoesOnFromWhereTheNearWalkEnded) {
  // A wall of 9 m, ten texels to the east, and a hole on the way.
  HeightMap map = gnomon::modules::flat_map(24, 5, 100);
  for (std::size_t row = 0; row < 5; ++row) map.samples[row * 24 + 14] = 109;
  map.samples[2 * 24 + 9] = GNOMON_NO_SAMPLE;
  const MapModules modules(map);
  const auto receiver = modules.gnomon_receiver_at(4.5F, 2.5F, 0);
  for (const float tangent : {0.8F, 1.0F}) {
    const auto ray = modules.gnomon_ray(modules.map(), receiver, vec3(1, 0.01F, tangent), 0);
    const auto near = modules.gnomon_near_walk(ray, 0, 0);
    ASSERT_EQ(near.cause, GNOMON_CAUSE_UNDECIDED);
    const float above = modules.gnomon_t_above(modules.map(), ray);
    const auto far = modules.gnomon_far_walk(modules.map(), ray, near, above, 0, modules.step_limit());
    EXPECT_EQ(far.cause, tangent < 0.9F ? GNOMON_CAUSE_SURFACE : GNOMON_CAUSE_ABOVE_ALL);
    EXPECT_GT(far.steps, near.steps);
    EXPECT_EQ(modules.gnomon_far_walk(modules.map(), ray, near, above, 0, near.steps).cause,
              GNOMON_CAUSE_UNDECIDED);
  }
}

}  // namespace
