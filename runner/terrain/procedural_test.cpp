// SPDX-License-Identifier: MIT
#include "terrain/procedural.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <set>

namespace gnomon::terrain {
namespace {

using Parameters = std::map<std::string, double>;

HeightMap make(const std::string& kind, int width, int height, const Parameters& parameters = {},
               std::uint32_t seed = 0) {
  const auto map = make_procedural(
      {.kind = kind, .width = width, .height = height, .seed = seed, .parameters = parameters});
  EXPECT_TRUE(map.ok()) << kind << ": " << (map.ok() ? "" : to_string(map.diagnostics()[0]));
  return *map;
}

std::string refusal(const ProceduralRequest& request) {
  const auto map = make_procedural(request);
  if (map.ok()) return "nothing was refused";
  EXPECT_EQ(map.diagnostics()[0].failure, Failure::kInvalid);
  return map.diagnostics()[0].message;
}

double highest(const HeightMap& map) {
  return *std::max_element(map.samples.begin(), map.samples.end());
}
double lowest(const HeightMap& map) {
  return *std::min_element(map.samples.begin(), map.samples.end());
}

/// FNV-1a over the bits of the samples.
std::uint64_t fingerprint(const HeightMap& map) {
  std::uint64_t hash = 14695981039346656037u;
  for (const float sample : map.samples)
    for (int k = 0; k < 4; ++k)
      hash = (hash ^ (std::bit_cast<std::uint32_t>(sample) >> (8 * k) & 0xffu)) * 1099511628211u;
  return hash;
}

TEST(Procedural, SamplesAreTheSameToTheBitOnEveryMachine) {
  const std::map<std::string, std::uint64_t> known{
      {"flat", 0x332fc06af0b9a325u},   {"plane", 0x0ba11b2b4a09bf25u},   {"wall", 0x6c8fb398770f3325u},
      {"step", 0xf9eaa3d577bf8325u},   {"steps", 0x69d5f9e34a07bd25u},   {"cone", 0xdb45ac307e7574eau},
      {"spikes", 0xf8a09a15810734b2u}, {"posts", 0xc8885beabd43dbe5u},   {"crater", 0xb4fed62e1d32c3c8u},
      {"gorge", 0xe5cd983556dbc554u},  {"checker", 0xbdf3d8f78aaf8325u}, {"fractal", 0xc65cb3b7d9253a21u},
  };
  for (const ProceduralKind& kind : procedural_kinds()) {
    ASSERT_TRUE(known.contains(kind.name)) << kind.name;
    EXPECT_EQ(fingerprint(make(kind.name, 96, 64, {}, 7)), known.at(kind.name)) << kind.name;
  }
}

TEST(Procedural, EveryKindMakesAnySize) {
  for (const ProceduralKind& kind : procedural_kinds())
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 40}, {40, 1}, {2, 2}, {33, 70}}) {
      const HeightMap map = make(kind.name, width, height);
      EXPECT_EQ(map.width, width);
      EXPECT_EQ(map.height, height);
      EXPECT_EQ(map.domain_width, width);
      EXPECT_EQ(map.domain_height, height);
      EXPECT_EQ(map.samples.size(), static_cast<std::size_t>(width * height));
      EXPECT_TRUE(
          std::all_of(map.samples.begin(), map.samples.end(), [](float h) { return std::isfinite(h); }))
          << kind.name << " " << width << " x " << height;
    }
}

TEST(Procedural, ExtremeParametersStayFinite) {
  for (const ProceduralKind& kind : procedural_kinds())
    for (const ProceduralParameter& parameter : kind.parameters)
      for (const double value : {parameter.minimum, parameter.maximum}) {
        const HeightMap map = make(kind.name, 24, 17, {{parameter.name, value}});
        EXPECT_TRUE(
            std::all_of(map.samples.begin(), map.samples.end(), [](float h) { return std::isfinite(h); }))
            << kind.name << " with " << parameter.name << " = " << value;
      }
}

TEST(Procedural, TheSeedChangesTheRandomKindsAndNoOther) {
  const std::set<std::string> random{"spikes", "posts", "gorge", "fractal"};
  for (const ProceduralKind& kind : procedural_kinds())
    EXPECT_EQ(make(kind.name, 64, 64, {}, 1).samples != make(kind.name, 64, 64, {}, 2).samples,
              random.contains(kind.name))
        << kind.name;
}

TEST(Procedural, TurnsAreClockwiseAndMirrorsSwapEastAndWest) {
  const HeightMap map = make("fractal", 40, 40);
  const HeightMap turned = make("fractal", 40, 40, {{"quarter_turns", 1}});
  const HeightMap mirrored = make("fractal", 40, 40, {{"mirror", 1}});
  const HeightMap both = make("fractal", 40, 40, {{"mirror", 1}, {"quarter_turns", 3}});
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 40; ++column) {
      EXPECT_EQ(turned.at(column, 39 - row), map.at(row, column));
      EXPECT_EQ(mirrored.at(row, 39 - column), map.at(row, column));
      EXPECT_EQ(both.at(39 - column, row), mirrored.at(row, column));
    }
}

TEST(Procedural, AMapThatIsTurnedKeepsItsShapeOnAnOblongGridToo) {
  const auto turned = make_procedural({.kind = "fractal",
                                       .width = 24,
                                       .height = 40,
                                       .spacing_x = 30,
                                       .spacing_y = 20,
                                       .parameters = {{"quarter_turns", 1}}});
  const auto map = make_procedural(
      {.kind = "fractal", .width = 40, .height = 24, .spacing_x = 20, .spacing_y = 30, .parameters = {}});
  for (int row = 0; row < 24; ++row)
    for (int column = 0; column < 40; ++column) EXPECT_EQ(turned->at(column, 23 - row), map->at(row, column));
}

TEST(Procedural, TheVerticalScaleMultipliesInDouble) {
  const auto map = make_procedural(
      {.kind = "flat", .width = 1, .height = 1, .vertical_scale = 0.1, .parameters = {{"height", 1076}}});
  EXPECT_EQ(map->samples[0], static_cast<float>(1076 * 0.1));
}

TEST(Plane, RisesTowardsEastAndNorth) {
  const auto map = make_procedural({.kind = "plane",
                                    .width = 5,
                                    .height = 4,
                                    .spacing_x = 10,
                                    .spacing_y = 20,
                                    .parameters = {{"slope_x", 0.5}, {"slope_y", 0.25}}});
  EXPECT_FLOAT_EQ(map->at(3, 0), 0.5f * 5 + 0.25f * 10);  // the sample nearest to the south-west corner
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 4; ++column) {
      EXPECT_FLOAT_EQ(map->at(row, column + 1) - map->at(row, column), 5);
      EXPECT_FLOAT_EQ(map->at(row, column) - map->at(row + 1, column), 5);
    }
}

TEST(Wall, StandsWhereItIsPut) {
  const HeightMap map = make("wall", 10, 3, {{"column", 4}, {"thickness", 2}, {"height", 7}});
  for (int column = 0; column < 10; ++column)
    EXPECT_EQ(map.at(1, column), column == 4 || column == 5 ? 7 : 0);
}

TEST(Step, FallsTowardsTheEast) {
  const HeightMap map = make("step", 10, 3, {{"column", 4}, {"height", 7}});
  for (int column = 0; column < 10; ++column) EXPECT_EQ(map.at(2, column), column < 4 ? 7 : 0);
}

TEST(Steps, DescendByEqualRises) {
  const HeightMap map = make("steps", 90, 2, {{"count", 8}, {"rise", 3}});
  for (int column = 0; column < 90; ++column) EXPECT_EQ(map.at(0, column), 3 * (8 - column / 10));
}

TEST(Cone, IsRoundAboutItsTip) {
  const HeightMap map = make("cone", 65, 65, {{"height", 20}, {"radius", 25}});
  EXPECT_EQ(map.at(32, 32), 20);
  for (int row = 0; row < 65; ++row)
    for (int column = 0; column < 65; ++column) {
      EXPECT_EQ(map.at(row, column), map.at(64 - row, column));
      EXPECT_EQ(map.at(row, column), map.at(column, row));
      const double r = std::hypot(row - 32, column - 32);
      EXPECT_NEAR(map.at(row, column), std::max(0.0, 20 * (1 - r / 25)), 1e-5);
    }
}

TEST(Cone, IsRoundInMetresNotInTexels) {
  const auto map = make_procedural({.kind = "cone",
                                    .width = 65,
                                    .height = 65,
                                    .spacing_x = 10,
                                    .spacing_y = 20,
                                    .parameters = {{"height", 100}, {"radius", 250}}});
  EXPECT_EQ(map->at(32 + 5, 32), map->at(32, 32 + 10));
}

TEST(Spikes, AreFiveOfFullHeight) {
  for (std::uint32_t seed = 0; seed < 20; ++seed) {
    const HeightMap map = make("spikes", 256, 256, {{"height", 90}}, seed);
    EXPECT_EQ(std::count(map.samples.begin(), map.samples.end(), 90.0f), 5) << "seed " << seed;
  }
}

TEST(Posts, StandOnceInEverySquare) {
  const HeightMap map = make("posts", 64, 48, {{"height", 4}, {"pitch", 16}});
  for (int top = 0; top < 48; top += 16)
    for (int left = 0; left < 64; left += 16) {
      int posts = 0;
      for (int row = top; row < top + 16; ++row)
        for (int column = left; column < left + 16; ++column) posts += map.at(row, column) == 4;
      EXPECT_EQ(posts, 1);
    }
}

TEST(Crater, IsAParaboloidInLevelGround) {
  const HeightMap map = make("crater", 101, 101, {{"depth", 12}, {"radius", 40}});
  for (int row = 0; row < 101; ++row)
    for (int column = 0; column < 101; ++column) {
      const double r2 = (row - 50) * (row - 50) + (column - 50) * (column - 50);
      EXPECT_NEAR(map.at(row, column), std::min(0.0, 12.0 / 1600 * (r2 - 1600)), 1e-5);
    }
  EXPECT_EQ(map.at(50, 50), -12);
}

TEST(Checker, AlternatesFromAHighSquareInTheNorthWest) {
  const HeightMap map = make("checker", 32, 32, {{"cell", 8}, {"height", 3}});
  EXPECT_EQ(map.at(0, 0), 3);
  EXPECT_EQ(map.at(0, 8), 0);
  EXPECT_EQ(map.at(8, 0), 0);
  EXPECT_EQ(map.at(15, 15), 3);
}

TEST(Fractal, ReliefIsAsDefined) {
  for (std::uint32_t seed = 0; seed < 5; ++seed) {
    const auto map = make_procedural({.kind = "fractal",
                                      .width = 128,
                                      .height = 90,
                                      .seed = seed,
                                      .spacing_x = 30,
                                      .spacing_y = 30,
                                      .parameters = {}});
    EXPECT_EQ(lowest(*map), 0);
    EXPECT_EQ(highest(*map), static_cast<float>(0.1 * 128 * 30));
  }
}

TEST(Fractal, OctavesAddDetailOfHalfTheSizeAndHalfTheHeight) {
  // Roughness: the mean square of the second difference along a row, of a sum of octaves with gain 1/2 and
  // lacunarity 2 it grows with every octave, while the large forms stay where they are.
  const auto roughness = [](const HeightMap& map) {
    double sum = 0;
    for (int row = 0; row < map.height; ++row)
      for (int column = 1; column + 1 < map.width; ++column) {
        const double d = map.at(row, column - 1) - 2.0 * map.at(row, column) + map.at(row, column + 1);
        sum += d * d;
      }
    return sum;
  };
  double rougher = 0;
  for (int octaves = 1; octaves <= 6; ++octaves) {
    const double now = roughness(make("fractal", 256, 256, {{"octaves", octaves}}));
    EXPECT_GT(now, rougher) << octaves << " octaves";
    rougher = now;
  }
}

TEST(Fractal, LooksTheSameAtAnyResolution) {
  // A map of twice as many samples over the same ground has the same mountains.
  const auto coarse = make_procedural({.kind = "fractal",
                                       .width = 64,
                                       .height = 64,
                                       .spacing_x = 2,
                                       .spacing_y = 2,
                                       .parameters = {{"octaves", 3}}});
  const auto fine = make_procedural({.kind = "fractal",
                                     .width = 128,
                                     .height = 128,
                                     .spacing_x = 1,
                                     .spacing_y = 1,
                                     .parameters = {{"octaves", 3}}});
  for (int row = 0; row < 64; ++row)
    for (int column = 0; column < 64; ++column) {
      const double mean = (fine->at(2 * row, 2 * column) + fine->at(2 * row, 2 * column + 1) +
                           fine->at(2 * row + 1, 2 * column) + fine->at(2 * row + 1, 2 * column + 1)) /
                          4.0;
      EXPECT_NEAR(coarse->at(row, column), mean, 0.1 * 12.8);
    }
}

TEST(Gorge, IsACanyonInAPlateau) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    const HeightMap map = make("gorge", 256, 256, {{"depth", 30}}, seed);
    // At least a third is plateau, a river runs from the west to the east edge deep below it.
    const auto on_plateau =
        std::count_if(map.samples.begin(), map.samples.end(), [](float h) { return h > 27; });
    EXPECT_GT(on_plateau, 256 * 256 / 3) << "seed " << seed;
    for (int column = 0; column < 256; ++column) {
      float bed = 100;
      for (int row = 0; row < 256; ++row) bed = std::min(bed, map.at(row, column));
      EXPECT_LT(bed, 12) << "seed " << seed << ", column " << column;
    }
  }
}

TEST(Procedural, WhatIsUnknownIsNamedWithWhatIsKnown) {
  EXPECT_NE(refusal({.kind = "hill", .parameters = {}}).find("'hill'; there are flat, plane, wall"),
            std::string::npos);
  EXPECT_NE(refusal({.kind = "cone", .parameters = {{"hight", 1}}})
                .find("'hight'; it has height, radius, column, row"),
            std::string::npos);
}

TEST(Procedural, EveryMistakeIsSaidAtOnce) {
  const auto map = make_procedural({.kind = "cone",
                                    .width = 0,
                                    .height = 16385,
                                    .spacing_x = -1,
                                    .parameters = {{"hight", 1}, {"radius", -3}}});
  ASSERT_FALSE(map.ok());
  EXPECT_EQ(map.diagnostics().size(), 5u);
}

TEST(Procedural, NumbersOutOfRangeAreRefused) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kNaN, kInfinity, -kInfinity, 1e300})
    EXPECT_NE(refusal({.kind = "flat", .parameters = {{"height", bad}}}).find("'height'"), std::string::npos);
  EXPECT_NE(refusal({.kind = "posts", .parameters = {{"pitch", 2.5}}}).find("whole number from 1 to"),
            std::string::npos);
  for (const double bad : {0.0, kNaN, kInfinity}) {
    EXPECT_NE(refusal({.kind = "flat", .spacing_y = bad, .parameters = {}}).find("spacing"),
              std::string::npos);
  }
  EXPECT_NE(refusal({.kind = "flat", .vertical_scale = kNaN, .parameters = {}}).find("vertical scale"),
            std::string::npos);
  EXPECT_NE(
      refusal(
          {.kind = "flat", .width = 8, .height = 8, .vertical_scale = 1e38, .parameters = {{"height", 10}}})
          .find("single precision"),
      std::string::npos);
}

TEST(Procedural, KindsDescribeThemselves) {
  std::set<std::string> names;
  for (const ProceduralKind& kind : procedural_kinds()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.name;
    EXPECT_FALSE(kind.description.empty());
    for (const ProceduralParameter& parameter : kind.parameters) {
      EXPECT_FALSE(parameter.unit.empty()) << kind.name << "." << parameter.name;
      EXPECT_FALSE(parameter.description.empty()) << kind.name << "." << parameter.name;
      EXPECT_FALSE(parameter.default_value.empty()) << kind.name << "." << parameter.name;
    }
  }
  EXPECT_EQ(names, (std::set<std::string>{"flat", "plane", "wall", "step", "steps", "cone", "spikes", "posts",
                                          "crater", "gorge", "checker", "fractal"}));
}

}  // namespace
}  // namespace gnomon::terrain
