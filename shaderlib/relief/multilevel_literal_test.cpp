// SPDX-License-Identifier: MIT
// The papers' own method: against their text in double precision, written down a second time, and where it is
// wrong, against the oracle.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "oracle/oracle.h"
#include "technique/surface.h"
#include "terrain/load.h"
#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

using technique::surface_of;
using terrain::HeightMap;

HeightMap make(const std::string& kind, int width, int height, double spacing = 10) {
  return terrain::make_procedural({.kind = kind,
                                   .width = width,
                                   .height = height,
                                   .seed = 3,
                                   .spacing_x = spacing,
                                   .spacing_y = spacing})
      .value();
}

HeightMap jacksboro() {
  return terrain::load_height_map(GNOMON_SOURCE_SHADERLIB "/../testcases/terrain/jacksboro.png",
                                  {.spacing = {{74.85, 92.47}}, .channel = {}})
      .value()
      .map;
}

/// The modules over every level of a map, with the H_ext of the map itself for all of them, as the papers
/// have it.
class PaperModules final : public Modules {
 public:
  explicit PaperModules(const HeightMap& base) : base_(base) {
    for (int q = 0; q <= terrain::coarsest_level(base.width, base.height); ++q)
      levels_.push_back(terrain::level(base, q));
  }

  [[nodiscard]] float gnomon_host_height(ivec2 sample, int q) const override {
    const HeightMap& map = level(q);
    return map.at(clamp(sample.y, 0, map.height - 1), clamp(sample.x, 0, map.width - 1));
  }
  [[nodiscard]] float gnomon_host_extrema(ivec2, int, int) const override { return base_.map().highest; }
  [[nodiscard]] vec2 gnomon_host_literal_extrema(ivec2 block, int level) const override {
    return base_.gnomon_host_literal_extrema(block, level);
  }

  [[nodiscard]] const HeightMap& level(int q) const { return levels_.at(static_cast<std::size_t>(q)); }
  [[nodiscard]] GnomonMap map(int q) const {
    const HeightMap& map = level(q);
    return {.size = ivec2(map.width, map.height),
            .domain = vec2(map.domain_width, map.domain_height),
            .spacing = vec2(map.spacing_x, map.spacing_y),
            .highest = base_.map().highest,
            .top_level = base_.literal_top_level()};
  }
  /// At (column, row) in texels of H_q.
  [[nodiscard]] GnomonShadow answer(float column, float row, vec3 sun, int q = 0) const {
    const HeightMap& map = level(q);
    return gnomon_multilevel_literal(this->map(q), gnomon_receiver_at(column, row, 0), sun, q,
                                     2 * (map.width + map.height));
  }

 private:
  MapModules base_;
  std::vector<HeightMap> levels_;
};

vec3 to_sun(double azimuth, double elevation) {
  const auto ground = oracle::ground_direction(azimuth);
  const double angle = elevation * std::numbers::pi / 180;
  return vec3(ground.east * std::cos(angle), ground.north * std::cos(angle), std::sin(angle));
}

/// Algo 2 and 3 in double precision, in texture coordinates 0..1 as the papers have them, with levels of
/// H_ext counted from 0. Only what keeps it running is put right: c, g, h, k, l, m.
class SecondReading {
 public:
  explicit SecondReading(const HeightMap& base) : base_(base) {
    dvec2 (SecondReading::*pick)(int, int, std::size_t) const = &SecondReading::of_texels;
    ivec2 size(base.width, base.height);
    while (std::max(size.x, size.y) > 2) {
      size = (size + 1) / 2;
      Extrema next{size, {}};
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) next.values.push_back((this->*pick)(x, y, extrema_.size()));
      extrema_.push_back(std::move(next));
      pick = &SecondReading::of_blocks;
    }
  }

  [[nodiscard]] bool shadow(const HeightMap& level_map, int q, dvec2 texel, dvec3 s) const {
    if (s.z <= 0) return true;
    if (s.x == 0 && s.y == 0) return false;
    // A texture coordinate of 1 is the end of the texels of level q; the map's own end may lie before.
    const dvec2 texels(level_map.width, level_map.height);
    const dvec2 metres(level_map.spacing_x, level_map.spacing_y);
    const dvec2 start = texel / texels;
    const double height = oracle::surface_height(surface_of(level_map), texel.x, texel.y);
    const dvec2 u = normalize(dvec2(s.x, -s.y) / metres / texels);
    const auto is_hidden = [&](dvec2 at, double h) {
      const dvec2 moved = (at - start) * texels * metres;
      const dvec3 v(moved.x, -moved.y, h - height);
      const dvec3 r = cross(s, dvec3(0, 0, 1));
      return dot(r, cross(v, s)) <= 0;
    };
    ivec2 current(floor(texel));
    dvec2 in = start;
    step(current, 1, texels, u, current, in);
    const int coarsest = std::max(q, static_cast<int>(extrema_.size()));
    for (int l = q;
         current.x >= 0 && current.y >= 0 && current.x < level_map.width && current.y < level_map.height;) {
      const int side = 1 << (l - q);
      const ivec2 low = current / side * side;
      dvec2 out = in;
      ivec2 next = current;
      step(low, side, texels, u, next, out);
      double highest = 0;
      dvec2 at = out;
      if (l == q) {
        at = (in + out) / 2.0;
        highest = oracle::surface_height(surface_of(level_map), at.x * texels.x, at.y * texels.y);
      } else {
        const dvec2 both = extrema_[static_cast<std::size_t>(l - 1)].at(current / side);
        if (is_hidden(out, both.y)) return true;
        highest = both.x;
      }
      if (is_hidden(at, highest)) {
        if (l == q) return true;
        --l;
        continue;
      }
      current = next;
      in = out;
      l = coarsest;
    }
    return false;
  }

 private:
  struct Extrema {
    ivec2 size;
    std::vector<dvec2> values;
    [[nodiscard]] dvec2 at(ivec2 i) const {
      const ivec2 c = clamp(i, ivec2(0), size - 1);
      return values[static_cast<std::size_t>(c.y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(c.x)];
    }
  };

  static dvec2 wider(dvec2 a, dvec2 b) { return {std::max(a.x, b.x), std::min(a.y, b.y)}; }

  [[nodiscard]] dvec2 of_texels(int x, int y, std::size_t) const {
    dvec2 both(-1e300, 1e300);
    for (int i = 0; i < 9; ++i) {
      const double column = std::min(2 * x + i % 3, base_.width);
      const double row = std::min(2 * y + i / 3, base_.height);
      both = wider(both, dvec2(oracle::surface_height(surface_of(base_), column, row)));
    }
    return both;
  }
  [[nodiscard]] dvec2 of_blocks(int x, int y, std::size_t done) const {
    const Extrema& below = extrema_[done - 1];
    dvec2 both = below.at({2 * x, 2 * y});
    for (const ivec2 i : {ivec2(1, 0), ivec2(0, 1), ivec2(1, 1)})
      both = wider(both, below.at(ivec2(2 * x, 2 * y) + i));
    return both;
  }

  // Leaves the block that begins at `low`: `point` becomes P_out, `current` the texel behind it.
  static void step(ivec2 low, int side, dvec2 texels, dvec2 u, ivec2& current, dvec2& point) {
    const dvec2 ds = 1.0 / texels;
    const ivec2 from = current;
    dvec2 t(1e300);
    for (int axis = 0; axis < 2; ++axis) {
      if (std::abs(u[axis]) <= 1.2e-7) continue;
      const double corner = (low[axis] + (u[axis] > 0 ? side : 0)) * ds[axis];
      t[axis] = (corner - point[axis]) / u[axis];
    }
    const double first = std::min(t.x, t.y);
    point += u * first;
    for (int axis = 0; axis < 2; ++axis) {
      if (t[axis] == first) {
        current[axis] = u[axis] > 0 ? low[axis] + side : low[axis] - 1;
        continue;
      }
      const int there = static_cast<int>(std::floor(point[axis] * texels[axis]));
      current[axis] = u[axis] >= 0 ? std::clamp(there, from[axis], low[axis] + side - 1)
                                   : std::clamp(there, low[axis], from[axis]);
    }
  }

  HeightMap base_;
  std::vector<Extrema> extrema_;
};

class LiteralOn : public testing::TestWithParam<const char*> {};

// Single precision decides a few rays otherwise: those that graze, and those that pass a texel's corner.
TEST_P(LiteralOn, IsThePapersTextReadASecondTime) {
  const HeightMap base = make(GetParam(), 128, 64);
  const PaperModules modules(base);
  const SecondReading reading(base);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  int rays = 0;
  int different = 0;
  int undecided = 0;
  int shadowed = 0;
  for (int q = 0; q <= 7; ++q) {
    const HeightMap& map = modules.level(q);
    for (int i = 0; i < 4000; ++i) {
      const float column = static_cast<float>(unit(random) * map.domain_width);
      const float row = static_cast<float>(unit(random) * map.domain_height);
      const vec3 sun = to_sun(360 * unit(random), 0.5 + 60 * std::pow(unit(random), 2));
      const auto answer = modules.answer(column, row, sun, q);
      const bool expected = reading.shadow(map, q, dvec2(column, row), dvec3(sun));
      ++rays;
      different += (answer.shadow > 0) != expected;
      undecided += answer.cause == GNOMON_CAUSE_UNDECIDED;
      shadowed += expected;
    }
  }
  std::cout << GetParam() << ": " << rays << " rays, " << shadowed << " in shadow, " << different
            << " different in single precision\n";
  EXPECT_LE(different, rays / 1000);
  EXPECT_EQ(undecided, 0);
  EXPECT_GT(shadowed, 50);
}

INSTANTIATE_TEST_SUITE_P(Maps, LiteralOn, testing::Values("fractal", "gorge", "spikes", "steps", "posts"),
                         [](const auto& instance) { return std::string(instance.param); });

struct Minimum {
  int rays = 0, shadowed = 0, fired = 0, fired_in_light = 0, wrong = 0;
};

Minimum count_minimum(const HeightMap& map) {
  const PaperModules modules(map);
  Minimum count;
  for (const double azimuth : {0.0, 45.0, 217.3, 315.0}) {
    std::vector<oracle::Receiver> receivers;
    for (int row = 0; row < map.height; row += 3)
      for (int column = 0; column < map.width; column += 3) receivers.push_back({column + 0.5, row + 0.5, 0});
    const auto horizons = oracle::horizons(surface_of(map), receivers, oracle::ground_direction(azimuth));
    for (const double elevation : {1.0, 3.0, 10.0, 25.0}) {
      for (std::size_t i = 0; i < receivers.size(); ++i) {
        const auto answer = modules.answer(static_cast<float>(receivers[i].column),
                                           static_cast<float>(receivers[i].row), to_sun(azimuth, elevation));
        const bool truth = oracle::in_shadow(horizons[i], elevation);
        const bool fired = answer.cause == GNOMON_CAUSE_BELOW_BLOCK;
        count.rays += 1;
        count.shadowed += truth;
        count.fired += fired;
        count.fired_in_light += fired && !truth;
        count.wrong += (answer.shadow > 0) != truth;
      }
    }
  }
  return count;
}

// Erratum o: with the text as printed the minimum does fire; docs/errata.md reports these figures.
TEST(MultilevelLiteral, CountsHowOftenTheMinimumOfABlockProvesShadow) {
  for (const auto& [name, map] : {std::pair{"jacksboro", jacksboro()},
                                  {"gorge", make("gorge", 256, 256)},
                                  {"crater", make("crater", 256, 256)}}) {
    const Minimum count = count_minimum(map);
    std::cout << name << ": " << count.rays << " rays, " << count.shadowed << " in shadow, h_min fired on "
              << count.fired << ", of which in the light " << count.fired_in_light << "; wrong "
              << count.wrong << "\n";
    EXPECT_GT(count.fired, 0);
  }
}

TEST(MultilevelLiteral, AnswersSunsThatNeedNoRay) {
  const PaperModules modules(make("fractal", 32, 32));
  EXPECT_EQ(modules.answer(9.5F, 9.5F, vec3(0, 0, 1)).cause, GNOMON_CAUSE_ZENITH);
  EXPECT_EQ(modules.answer(9.5F, 9.5F, vec3(1, 0, 0)).shadow, 1.0F);
}

// Errata g, k, m: every ray ends, whatever its direction and level, and 2 (width + height) blocks suffice.
TEST(MultilevelLiteral, EndsInEveryDirectionAtEveryLevel) {
  for (const auto& [width, height] : {std::pair{64, 64}, {61, 34}, {1, 9}, {9, 1}, {2, 2}, {1, 1}}) {
    const PaperModules modules(make("checker", width, height));
    for (int q = 0; q <= terrain::coarsest_level(width, height); ++q) {
      for (int azimuth = 0; azimuth < 360; azimuth += 15) {
        for (const float place : {0.0F, 0.5F, 0.77F, 1.0F}) {
          const vec2 domain = modules.map(q).domain;
          const auto answer =
              modules.answer(place * domain.x, (1 - place) * domain.y, to_sun(azimuth, 0.01), q);
          EXPECT_NE(answer.cause, GNOMON_CAUSE_UNDECIDED) << width << "x" << height << " q " << q;
        }
      }
    }
  }
}

TEST(MultilevelLiteral, StepLimitLeavesItUndecided) {
  const PaperModules modules(make("flat", 64, 64));
  const auto answer = modules.gnomon_multilevel_literal(
      modules.map(0), modules.gnomon_receiver_at(2.5F, 9.5F, 0), vec3(1, 0, 1e-6F), 0, 2);
  EXPECT_EQ(answer.cause, GNOMON_CAUSE_UNDECIDED);
}

// Erratum d: H_ext comes from H_0 and does not bound H_1.
TEST(LiteralHeight, OfACoarserLevelRisesAboveTheBlocksMaximum) {
  HeightMap map =
      terrain::make_procedural({.kind = "flat", .width = 16, .height = 16, .parameters = {{"height", 0}}})
          .value();
  for (std::size_t i = 0; i < 256; ++i) map.samples[i] = i % 16 >= 5 ? 1.0F : 0.0F;
  const PaperModules modules(map);
  EXPECT_FLOAT_EQ(modules.gnomon_literal_height(vec2(3.9F / 2, 4), 1), 0.225F);
  EXPECT_EQ(modules.gnomon_host_literal_extrema(ivec2(0, 0), 2).x, 0.0F);
}

TEST(LiteralFlag, IsShadowWhereTheViewIsNotBelowTheSun) {
  const MapModules modules(flat_map(4, 4));
  for (int azimuth = 0; azimuth < 360; azimuth += 15) {
    const vec3 sun = to_sun(azimuth, 30);
    const vec3 ground = normalize(vec3(sun.x, sun.y, 0));
    EXPECT_TRUE(modules.gnomon_literal_flag(100.0F * ground + vec3(0, 0, 58), sun));
    EXPECT_FALSE(modules.gnomon_literal_flag(100.0F * ground + vec3(0, 0, 57), sun));
    // Erratum j: that r = s x n is no unit vector changes no sign.
    const vec3 up(0, 0, 1);
    for (const float z : {57.0F, 58.0F}) {
      const vec3 v = 100.0F * ground + vec3(0, 0, z);
      const float p = dot(normalize(cross(sun, up)), cross(v, sun));
      EXPECT_EQ(modules.gnomon_literal_flag(v, sun), p <= 0);
    }
  }
  EXPECT_TRUE(modules.gnomon_literal_flag(vec3(8, 0, 2), vec3(2, 0, 0.5F))) << "grazing counts, erratum i";
  EXPECT_FALSE(modules.gnomon_literal_flag(vec3(8, 0, 2), vec3(0, 0, 1))) << "the zenith";
}

TEST(LiteralTrack, StartsAtTheReceiverAndHasAUnitDirection) {
  const PaperModules modules(make("plane", 32, 32));
  auto map = modules.map(0);
  map.spacing = vec2(10, 20);
  const auto track =
      modules.gnomon_literal_track(map, modules.gnomon_receiver_at(9.25F, 3.75F, 7), to_sun(45, 30), 0);
  EXPECT_EQ(track.start, vec2(9.25F, 3.75F));
  EXPECT_EQ(track.height, modules.gnomon_literal_height(vec2(9.25F, 3.75F), 0) + 7);
  EXPECT_FLOAT_EQ(length(track.direction), 1.0F);
  EXPECT_FLOAT_EQ(track.direction.x, -2.0F * track.direction.y)
      << "north is up, and rows are twice as far apart";
}

TEST(LiteralHides, TurnsTexelsIntoMetresEastAndNorth) {
  const PaperModules modules(make("flat", 32, 32, 1));
  auto map = modules.map(0);
  map.spacing = vec2(10, 20);
  const auto receiver = modules.gnomon_receiver_at(9.5F, 9.5F, 0);
  const float ground = modules.gnomon_literal_height(vec2(9.5F), 0);
  // 4 texels of 20 m to the north at 45 degrees: 80 m.
  const auto north = modules.gnomon_literal_track(map, receiver, to_sun(0, 45), 0);
  EXPECT_TRUE(modules.gnomon_literal_hides(map, north, vec2(9.5F, 5.5F), ground + 80.1F));
  EXPECT_FALSE(modules.gnomon_literal_hides(map, north, vec2(9.5F, 5.5F), ground + 79.9F));
  const auto east = modules.gnomon_literal_track(map, receiver, to_sun(90, 45), 0);
  EXPECT_TRUE(modules.gnomon_literal_hides(map, east, vec2(13.5F, 9.5F), ground + 40.1F));
  EXPECT_FALSE(modules.gnomon_literal_hides(map, east, vec2(13.5F, 9.5F), ground + 39.9F));
}

TEST(LiteralLook, GoesCloserOnlyWhereTheMaximumRisesToTheRayAtTheExit) {
  HeightMap map = make("flat", 16, 16, 1);
  for (std::size_t i = 0; i < 256; ++i) map.samples[i] = i % 16 >= 8 ? 1.0F : 0.0F;
  const PaperModules modules(map);
  const auto look = [&](float tangent, vec2 entry, vec2 exit_point, ivec2 block, int level) {
    const auto track = modules.gnomon_literal_track(modules.map(0), modules.gnomon_receiver_at(6.5F, 8.5F, 0),
                                                    vec3(1, 0, tangent), 0);
    return modules.gnomon_literal_look(modules.map(0), track, entry, exit_point, block, level, 0);
  };
  // The upper half, from column 8 on, looked at from 6.5: a wall of 1 m, 9.5 m away where the track leaves
  // it.
  EXPECT_EQ(look(0.3F, vec2(8, 8.5F), vec2(16, 8.5F), ivec2(1, 1), 3), GNOMON_LITERAL_PASS) << "erratum b";
  EXPECT_EQ(look(0.1F, vec2(8, 8.5F), vec2(16, 8.5F), ivec2(1, 1), 3), GNOMON_LITERAL_DESCEND);
  EXPECT_EQ(look(0.3F, vec2(8, 8.5F), vec2(9, 8.5F), ivec2(8, 8), 0), GNOMON_LITERAL_SURFACE);
  EXPECT_EQ(look(0.6F, vec2(8, 8.5F), vec2(9, 8.5F), ivec2(8, 8), 0), GNOMON_LITERAL_PASS);
  EXPECT_EQ(look(0.05F, vec2(12, 8.5F), vec2(16, 8.5F), ivec2(3, 2), 2), GNOMON_LITERAL_MINIMUM);
}

}  // namespace
}  // namespace gnomon::modules
