// SPDX-License-Identifier: MIT
// The claim the product rests on: on the GPU, no pixel outside the band differs from the double-precision
// oracle.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "gl/draw.h"
#include "judge/judge.h"
#include "technique/sun.h"
#include "technique/surface.h"
#include "terrain/level.h"
#include "testing/engine_fixture.h"

namespace gnomon {
namespace {

const std::array<std::string, 7> kMaps{"fractal", "gorge", "spikes", "steps", "posts", "crater", "real"};

struct View {
  double azimuth, elevation, receiver_height;
};

/// Azimuths on axes, on diagonals and odd ones; elevations from 0.1 to 89.9 degrees; receivers on and above
/// the ground.
constexpr std::array<View, 8> kViews{{{90, 0.1, 0},
                                      {45, 2, 0},
                                      {213.7, 5, 0},
                                      {180, 10, 0.5},
                                      {315, 20, 0},
                                      {301.3, 35, 50},
                                      {0, 60, 0.5},
                                      {17.9, 89.9, 0}}};

struct Tally {
  double rays = 0, mismatches = 0, in_band = 0;
};

void ask(Engine& engine, const scene::Scene& scene, Tally& tally) {
  const Result<Rendered> actual = engine.render(scene);
  ASSERT_TRUE(actual.ok()) << to_string(actual.diagnostics().front());
  const Result<image::Image> reference = engine.reference(scene, actual->ground);
  ASSERT_TRUE(reference.ok());
  const judge::Verdict verdict = judge::compare(actual->image, *reference, {.channels = {"b_shadow"}});
  EXPECT_TRUE(verdict.passed) << scene.id << " q " << *scene.shadow.q << " azimuth " << scene.sun.azimuth
                              << " elevation " << scene.sun.elevation << ": " << verdict.measured;
  tally.rays += verdict.compared + verdict.in_band;
  tally.mismatches += verdict.mismatches;
  tally.in_band += verdict.in_band;
}

void print(const char* what, const Tally& tally) {
  std::cout << what << ": " << static_cast<long>(tally.rays) << " rays, " << tally.mismatches
            << " mismatches, " << tally.in_band << " in band\n";
}

TEST(Multilevel, NoPixelDiffersFromTheOracleAtLevelZero) {
  Engine engine = testing::make_engine();
  Tally tally;
  for (const std::string& map : kMaps) {
    scene::Scene scene = testing::scene_over(map, 333, 200);
    for (const View& view : kViews) {
      scene.sun = {view.azimuth, view.elevation};
      scene.shadow.receiver_height = view.receiver_height;
      ask(engine, scene, tally);
    }
  }
  print("level 0", tally);
  EXPECT_GE(tally.rays - tally.in_band, 1e6);
  EXPECT_LT(tally.in_band, 0.01 * tally.rays);
}

TEST(Multilevel, NoPixelDiffersFromTheOracleAtCoarserLevels) {
  Engine engine = testing::make_engine();
  Tally tally;
  std::size_t turn = 0;
  for (const std::string& map : kMaps) {
    scene::Scene scene = testing::scene_over(map, 333, 200);
    for (int q = 1; q <= 9; ++q) {
      for (int i = 0; i < 3; ++i) {
        const View& view = kViews[turn++ % kViews.size()];
        scene.sun = {view.azimuth, view.elevation};
        scene.shadow.receiver_height = view.receiver_height;
        scene.shadow.q = q;
        ask(engine, scene, tally);
      }
    }
  }
  print("levels 1 to L", tally);
  EXPECT_GE(tally.rays - tally.in_band, 1e6);
  EXPECT_LT(tally.in_band, 0.01 * tally.rays);
}

TEST(Multilevel, NoPixelDiffersFromTheOracleBetweenSamplesOfAnOddMap) {
  Engine engine = testing::make_engine();
  Tally tally;
  for (const std::string& map : kMaps) {
    scene::Scene scene = testing::scene_over(map, 333, 700);
    scene.camera = scene::MapCamera{.size = {{250, 190}}};
    scene.sun = {217.3, 7};
    ask(engine, scene, tally);
  }
  print("between samples", tally);
}

TEST(Pyramid, LevelsAreThoseOfTheCpuToTheBit) {
  Engine engine = testing::make_engine();
  ASSERT_TRUE(engine.gl_info().ok());
  for (const auto& [width, height] : {std::pair{333, 200}, {1, 1}, {1, 37}, {2, 2}, {129, 64}}) {
    const auto map = engine.terrain(testing::scene_over("fractal", width, height));
    ASSERT_TRUE(map.ok());
    for (int q = 0; q <= terrain::coarsest_level(width, height); ++q) {
      const Result<gl::Texture> texture = technique::build_level(engine.programs(), **map, q);
      ASSERT_TRUE(texture.ok());
      EXPECT_EQ(texture->download(), terrain::level(**map, q).samples)
          << width << " x " << height << ", level " << q;
    }
  }
}

/// Rays that each ask at an elevation of their own horizon, just outside the band.
struct OwnHorizonRays {
  std::vector<float> receivers, suns;  // RGBA
  std::vector<bool> expected;
};

void add_batch(const terrain::HeightMap& map, double steepest, int number, OwnHorizonRays& rays) {
  std::mt19937 random(static_cast<unsigned>(number));
  std::uniform_real_distribution<double> unit(0, 1);
  const double azimuth = number % 3 == 0 ? 45.0 * (number / 3 % 8) : 360 * unit(random);
  const auto height = std::array{0.0F, 0.0F, 0.5F, 50.0F}[static_cast<std::size_t>(number % 4)];
  const bool on_samples = number % 2 == 0;
  std::vector<oracle::Receiver> receivers;
  for (int i = 0; i < 400; ++i) {
    auto column = static_cast<float>(unit(random) * map.width);
    auto row = static_cast<float>(unit(random) * map.height);
    if (on_samples) {
      column = std::min(std::floor(column), static_cast<float>(map.width - 1)) + 0.5F;
      row = std::min(std::floor(row), static_cast<float>(map.height - 1)) + 0.5F;
    }
    receivers.push_back({column, row, height});
  }
  const oracle::Surface surface = technique::surface_of(map);
  const std::vector<double> horizons =
      oracle::horizons(surface, receivers, oracle::ground_direction(azimuth));
  const double band = oracle::band_width(on_samples, height, steepest);
  for (std::size_t i = 0; i < receivers.size(); ++i) {
    for (const double side : {-1.005, 1.005}) {
      const double elevation = (horizons[i] + side * band) * 180 / std::numbers::pi;
      if (elevation <= 0 || elevation >= 90) continue;
      const glm::vec3 sun(technique::to_sun({azimuth, elevation}));
      const auto column = static_cast<float>(receivers[i].column);
      rays.receivers.insert(rays.receivers.end(), {column, static_cast<float>(receivers[i].row), height, 0});
      rays.suns.insert(rays.suns.end(), {sun.x, sun.y, sun.z, 0});
      rays.expected.push_back(side < 0);
    }
  }
}

constexpr gl::Size kAsked{400, 250};  // 10^5 rays a map

OwnHorizonRays own_horizon_rays(const terrain::HeightMap& map) {
  OwnHorizonRays rays;
  const double steepest = oracle::steepest_slope(technique::surface_of(map));
  constexpr std::size_t wanted = std::size_t{kAsked.width} * kAsked.height;
  for (int number = 0; rays.expected.size() < wanted && number < 4000; ++number)
    add_batch(map, steepest, number, rays);
  rays.receivers.resize(4 * wanted);
  rays.suns.resize(4 * wanted);
  rays.expected.resize(wanted);
  return rays;
}

class OwnHorizon : public ::testing::TestWithParam<std::string> {};

TEST_P(OwnHorizon, NoRayIsOnTheWrongSide) {
  Engine engine = testing::make_engine();
  ASSERT_TRUE(engine.gl_info().ok());
  const auto map = engine.terrain(testing::scene_over(GetParam(), 333, 200));
  ASSERT_TRUE(map.ok());
  const Result<technique::Pyramid> pyramid = technique::build_pyramid(engine.programs(), **map, 0);
  const auto program = engine.programs().get(GNOMON_SOURCE_DIR "/runner/testing/own_horizon.frag");
  ASSERT_TRUE(program.ok()) << to_string(program.diagnostics().front());

  const OwnHorizonRays rays = own_horizon_rays(**map);
  Result<gl::Texture> receivers = gl::Texture::create(gl::Format::kRgba32F, kAsked);
  Result<gl::Texture> suns = gl::Texture::create(gl::Format::kRgba32F, kAsked);
  const Result<gl::Texture> answers = gl::Texture::create(gl::Format::kRgba32F, kAsked);
  receivers->upload(rays.receivers);
  suns->upload(rays.suns);
  const Result<Done> drawn = gl::draw({.program = &(*program)->program,
                                       .uniforms = {{"u_map_spacing", pyramid->spacing},
                                                    {"u_map_highest", pyramid->highest},
                                                    {"u_map_top_level", pyramid->top_level()}},
                                       .samplers = {{.name = "gnomon_heights", .texture = &pyramid->heights},
                                                    {.name = "gnomon_extrema",
                                                     .texture = &pyramid->extrema,
                                                     .last_level = pyramid->top_level() - 1},
                                                    {.name = "u_receivers", .texture = &receivers.value()},
                                                    {.name = "u_suns", .texture = &suns.value()}},
                                       .target = &answers.value()});
  ASSERT_TRUE(drawn.ok());
  const std::vector<float> texels = answers->download();
  int wrong = 0;
  for (std::size_t i = 0; i < rays.expected.size(); ++i) {
    const bool undecided = texels[4 * i + 2] == 0.0F;
    wrong += undecided || (texels[4 * i] > 0.5F) != rays.expected[i];
  }
  std::cout << GetParam() << " at its own horizon: " << rays.expected.size() << " rays, " << wrong
            << " on the wrong side\n";
  EXPECT_EQ(wrong, 0);
}

INSTANTIATE_TEST_SUITE_P(Maps, OwnHorizon, ::testing::ValuesIn(kMaps),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace gnomon
