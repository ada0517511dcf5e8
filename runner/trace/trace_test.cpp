// SPDX-License-Identifier: MIT
// What is told of a walk, against what heights and geometry say.
#include "trace/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "terrain/procedural.h"

namespace gnomon::trace {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

terrain::HeightMap flat(int width, int height, double spacing) {
  return {.width = width,
          .height = height,
          .spacing_x = spacing,
          .spacing_y = spacing,
          .domain_width = double(width),
          .domain_height = double(height),
          .samples = std::vector<float>(static_cast<std::size_t>(width * height), 5.0F)};
}

terrain::HeightMap fractal() {
  const auto map = terrain::make_procedural(
      {.kind = "fractal", .width = 150, .height = 90, .seed = 3, .spacing_x = 10, .spacing_y = 10});
  EXPECT_TRUE(map.ok());
  return *map;
}

scene::Scene with_sun(double azimuth, double elevation, const std::string& method = "multilevel") {
  scene::Scene scene;
  scene.id = "s";
  scene.file = "s.json";
  scene.sun = {azimuth, elevation};
  scene.shadow.method = method;
  return scene;
}

Trace traced(const scene::Scene& scene, const terrain::HeightMap& map, glm::ivec2 pixel) {
  Result<Trace> trace = trace_pixel(scene, map, pixel);
  EXPECT_TRUE(trace.ok()) << to_string(trace.diagnostics().front());
  return std::move(trace).value();
}

std::string refusal(const scene::Scene& scene, const terrain::HeightMap& map, glm::ivec2 pixel) {
  const Result<Trace> trace = trace_pixel(scene, map, pixel);
  return trace.ok() ? "" : to_string(trace.diagnostics().front());
}

// A wall, one sample high, 8 samples east of the receiver: 2 m a sample, so 16 m away.
TEST(Trace, EndsAtTheWallAndSaysHowFarItRises) {
  terrain::HeightMap map = flat(32, 16, 2);
  for (int row = 0; row < 16; ++row) map.samples[static_cast<std::size_t>(row * 32 + 20)] = 25;
  const scene::Scene scene = with_sun(90, 45);
  for (const std::string method : {"multilevel", "brute_force"}) {
    scene::Scene by = scene;
    by.shadow.method = method;
    const Trace trace = traced(by, map, {12, 5});
    const Walk& walk = *trace.walk;
    ASSERT_EQ(walk.steps.size(), static_cast<std::size_t>(walk.count));
    EXPECT_EQ(walk.shadow, 1);
    EXPECT_EQ(walk.height, 5);
    const Step& last = walk.steps.back();
    EXPECT_EQ(last.decision, Decision::kHides);
    EXPECT_EQ(last.index, glm::ivec2(20, 6)) << "the patch between columns 19 and 20";
    EXPECT_NEAR(last.distance[0], 14, 1e-5);
    EXPECT_NEAR(last.distance[1], 16, 1e-5);
    EXPECT_NEAR(last.ray[1], 21, 1e-5);
    EXPECT_NEAR((*last.surface)[1], 25, 1e-5);
    EXPECT_NE(last.reason.find("rises 4 m above"), std::string::npos) << last.reason;
    EXPECT_TRUE(trace.oracle.shadow);
    EXPECT_FALSE(trace.oracle.in_band);
    EXPECT_NEAR(trace.oracle.horizon, std::atan2(20, 16), 1e-6);
  }
}

/// Highest sample at the corners of the patches of a block.
float highest_of(const terrain::HeightMap& map, const Step& step) {
  const glm::ivec2 low = step.index << step.level;
  float highest = -1e9F;
  for (int y = low.y - 1; y < low.y + (1 << step.level); ++y)
    for (int x = low.x - 1; x < low.x + (1 << step.level); ++x)
      highest = std::max(highest, map.at(std::clamp(y, 0, map.height - 1), std::clamp(x, 0, map.width - 1)));
  return highest;
}

void expect_true_story(const Trace& trace, const terrain::HeightMap& map, double elevation) {
  const Walk& walk = *trace.walk;
  for (std::size_t i = 0; i < walk.steps.size(); ++i) {
    const Step& step = walk.steps[i];
    EXPECT_EQ(step.number, static_cast<int>(i) + 1);
    EXPECT_LE(step.t[0], step.t[1]);
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}})
      EXPECT_NEAR(step.ray[end], walk.height + step.distance[end] * std::tan(elevation * kDegree),
                  1e-4 + 1e-5 * step.distance[end]);
    const bool closer = step.decision == Decision::kDescends;
    if (i + 1 < walk.steps.size()) {
      const Step& next = walk.steps[i + 1];
      EXPECT_EQ(next.t[0], closer ? step.t[0] : step.t[1]) << step.reason;
      EXPECT_TRUE(closer ? next.level == step.level - 1 : next.level <= step.level + 1);
      if (step.level == 0 && next.level == 0) {
        EXPECT_NEAR((*step.surface)[1], (*next.surface)[0], 1e-3) << "the surface has no gap";
      }
    }
    if (step.level > 0) {
      EXPECT_EQ(*step.highest, highest_of(map, step));
      EXPECT_EQ(closer, *step.highest > step.ray[0]) << step.number << ": " << step.reason;
    } else {
      const bool hides = step.decision == Decision::kHides;
      EXPECT_EQ(hides, walk.shadow == 1 && i + 1 == walk.steps.size());
      if (step.distance[0] > 0 && !hides) {
        EXPECT_LE((*step.surface)[1], step.ray[1]);
      }
    }
  }
}

TEST(Trace, EveryStepIsTrueAndFollowsFromTheOneBefore) {
  const terrain::HeightMap map = fractal();
  int shadows = 0;
  int steps = 0;
  for (const auto& [azimuth, elevation] : {std::pair{213.7, 5.0}, {90.0, 2.0}, {45.0, 10.0}, {331.0, 25.0}}) {
    for (int i = 0; i < 60; ++i) {
      scene::Scene scene = with_sun(azimuth, elevation);
      // Between samples too, where a ray crosses several patches before it is a texel away.
      if (i % 2 == 1) scene.camera = scene::MapCamera{.size = {{131, 77}}};
      const Trace trace = traced(scene, map, {(i * 37) % 131, (i * 53) % 77});
      expect_true_story(trace, map, elevation);
      shadows += trace.walk->shadow == 1;
      steps += trace.walk->count;
      EXPECT_TRUE(trace.oracle.shadow == (trace.walk->shadow == 1) || trace.oracle.in_band);
    }
  }
  EXPECT_GT(shadows, 20);
  EXPECT_LT(shadows, 220);
  EXPECT_GT(steps, 1000);
}

TEST(Trace, TellsThePapersTextAndItsMistake) {
  // Erratum b: 16 x 16 texels, 1 m from column 8 on, seen from (6.5, 8.5), the sun's tangent 0.3.
  terrain::HeightMap map = flat(16, 16, 1);
  for (std::size_t i = 0; i < map.samples.size(); ++i) map.samples[i] = i % 16 >= 8 ? 1.0F : 0.0F;
  const double elevation = std::atan(0.3) / kDegree;
  const Trace right = traced(with_sun(90, elevation), map, {6, 8});
  const Trace literal = traced(with_sun(90, elevation, "multilevel_literal"), map, {6, 8});
  EXPECT_EQ(right.walk->shadow, 1);
  EXPECT_TRUE(literal.oracle.shadow);
  ASSERT_FALSE(literal.walk->steps.empty());
  for (const Step& step : literal.walk->steps) {
    EXPECT_EQ(step.level > 0, step.highest.has_value());
    if (step.decision == Decision::kSkips) {
      EXPECT_LT(*step.highest, step.ray[1]);
    }
    if (step.decision == Decision::kDescends) {
      EXPECT_GE(*step.highest, step.ray[1]);
    }
  }
  const scene::Scene scene = with_sun(90, elevation, "multilevel_literal");
  if (literal.walk->shadow == 0) {
    EXPECT_NE(to_text(literal, scene).find("they DIFFER"), std::string::npos);
  }
}

TEST(Trace, GoesOnTheOtherSideOfEdgesBesideAHole) {
  terrain::HeightMap map = flat(16, 16, 1);
  map.holes = true;
  map.samples[9 * 16 + 5] = -1e30F;  // south of the row that the ray runs along
  const Trace trace = traced(with_sun(90, 10), map, {4, 8});
  const auto& steps = trace.walk->steps;
  EXPECT_TRUE(
      std::any_of(steps.begin(), steps.end(), [](const Step& s) { return s.decision == Decision::kHole; }));
  EXPECT_TRUE(steps.back().other_side);
  EXPECT_FALSE(steps.front().other_side);
  const Trace hole = traced(with_sun(90, 10), map, {5, 9});
  EXPECT_FALSE(hole.point.valid());
  EXPECT_FALSE(hole.walk);
  EXPECT_NE(to_text(hole, with_sun(90, 10)).find("verdict: nothing is asked"), std::string::npos);
}

TEST(Trace, SunsWithoutARayHaveNoSteps) {
  const terrain::HeightMap map = flat(8, 8, 1);
  for (const auto& [elevation, shadow] : {std::pair{-1.0, 1.0F}, {90.0, 0.0F}}) {
    const scene::Scene scene = with_sun(90, elevation);
    const Trace trace = traced(scene, map, {1, 1});
    EXPECT_TRUE(trace.walk->steps.empty());
    EXPECT_EQ(trace.walk->count, 0);
    EXPECT_EQ(trace.walk->shadow, shadow);
    EXPECT_NE(to_text(trace, scene).find("no ray is cast"), std::string::npos);
  }
}

TEST(Trace, RefusesWhatCannotBeTraced) {
  const terrain::HeightMap map = flat(8, 6, 1);
  EXPECT_EQ(
      refusal(with_sun(0, 10), map, {8, 0}),
      "--pixel: error: the image has no pixel (8, 0); it has the columns 0 to 7 and the rows 0 to 5, counted "
      "from its upper left corner");
  EXPECT_NE(refusal(with_sun(0, 10), map, {0, -1}), "");
  EXPECT_EQ(refusal(with_sun(0, 10), map, {7, 5}), "");
  EXPECT_NE(
      refusal(with_sun(0, 10, "reference"), map, {0, 0}).find("multilevel, multilevel_literal, brute_force"),
      std::string::npos);
}

TEST(Trace, TextAndJsonSayTheSame) {
  const terrain::HeightMap map = fractal();
  scene::Scene scene = with_sun(213.7, 5);
  scene.shadow.q = 1;
  scene.shadow.receiver_height = 0.5;
  const Trace trace = traced(scene, map, {70, 40});
  const std::string text = to_text(trace, scene);
  EXPECT_EQ(text.rfind("s: pixel (70, 40) of 150 x 90\n", 0), 0u) << text;
  EXPECT_NE(text.find("column 70.5, row 40.5"), std::string::npos);
  EXPECT_NE(text.find("0.5 m above the surface at q 1"), std::string::npos);
  const auto json = nlohmann::json::parse(to_json(trace, scene));
  EXPECT_EQ(json["pixel"], nlohmann::json({70, 40}));
  EXPECT_EQ(json["q"], 1);
  EXPECT_EQ(json["steps"], trace.walk->count);
  EXPECT_EQ(json["b_shadow"], static_cast<int>(trace.walk->shadow));
  EXPECT_EQ(json["cause"], cause_name(trace.walk->cause));
  ASSERT_EQ(json["walk"].size(), trace.walk->steps.size());
  for (std::size_t i = 0; i < trace.walk->steps.size(); ++i) {
    const std::string reason = json["walk"][i]["reason"];
    EXPECT_EQ(reason, trace.walk->steps[i].reason);
    EXPECT_NE(text.find(reason), std::string::npos);
  }
  const std::string verdict = text.substr(text.rfind("verdict: "));
  EXPECT_NE(verdict.find("steps " + std::to_string(trace.walk->count) + "): "), std::string::npos) << verdict;
  EXPECT_NE(verdict.find("the sun 5.000000"), std::string::npos) << verdict;
  EXPECT_NE(verdict.find("the band"), std::string::npos) << verdict;
}

}  // namespace
}  // namespace gnomon::trace
