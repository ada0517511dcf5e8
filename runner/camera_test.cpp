// SPDX-License-Identifier: MIT
// What perspective and orthographic cameras see, held against the oracle's rays; and that the shadow of what
// they see does not depend on them.
#include "technique/camera.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>

#include "oracle/oracle.h"
#include "oracle/view_ray.h"
#include "technique/surface.h"
#include "testing/engine_fixture.h"
#include "testing/view_check.h"
#include "testing/views.h"

namespace gnomon {
namespace {

using scene::ViewCamera;
using testing::orthographic;
using testing::perspective;
using testing::Seen;
using testing::views;
using Point = std::array<double, 3>;

struct Tally {
  long hits = 0, unsteady = 0, wrong = 0, shadowed = 0;
  double worst_pixel = 0, worst_depth = 0;
};

void check_pixel(const Rendered& rendered, const oracle::ViewTracer& tracer,
                 const technique::CameraRays& rays, int x, int y, Tally& tally) {
  const terrain::HeightMap& map = *rendered.map;
  const technique::Ground& ground = rendered.ground;
  const oracle::Surface surface = technique::surface_of(map);
  const std::size_t i = std::size_t(y) * std::size_t(ground.size.x) + std::size_t(x);
  const glm::dvec2 centre(x + 0.5, y + 0.5);
  const double depth = testing::true_depth(tracer, rays, centre);
  const double slack = testing::depth_slack(depth, map);
  if (!testing::is_steady(tracer, rays, centre, depth, slack)) {
    ++tally.unsteady;
    return;
  }
  if ((ground.valid[i] != 0) != (depth < testing::kNowhere)) {
    ++tally.wrong;
    return;
  }
  if (depth == testing::kNowhere) return;
  ++tally.hits;
  const double column = ground.column[i];
  const double row = ground.row[i];
  const glm::dvec3 point(column * map.spacing_x, (map.domain_height - row) * map.spacing_y,
                         oracle::surface_height(surface, column, row));
  const double off = glm::length(rays.project(point) - centre);
  const double nearer = std::abs(double{ground.depth[i]} - depth);
  tally.worst_pixel = std::max(tally.worst_pixel, off);
  tally.worst_depth = std::max(tally.worst_depth, nearer / slack);
  if (off > 0.02 || nearer > slack) ++tally.wrong;
}

class Camera : public ::testing::TestWithParam<Seen> {};

TEST_P(Camera, HitsTheSurfaceThatTheDoublePrecisionRayMeets) {
  Engine engine = testing::make_engine();
  const scene::Scene scene = testing::scene_of(GetParam());
  const Result<Rendered> rendered = engine.render(scene);
  ASSERT_TRUE(rendered.ok()) << to_string(rendered.diagnostics().front());
  const technique::CameraRays rays = technique::camera_rays(GetParam().camera);
  const oracle::Surface surface = technique::surface_of(*rendered->map);
  const oracle::ViewTracer tracer(surface);
  Tally tally;
  // Five rays in double precision a pixel: every seventh pixel, which no pattern of the view follows.
  const int pixels = static_cast<int>(rendered->ground.pixels());
  for (int i = 0; i < pixels; i += 7)
    check_pixel(*rendered, tracer, rays, i % rendered->ground.size.x, i / rendered->ground.size.x, tally);
  std::cout << GetParam().name << ": " << tally.hits << " hits, " << tally.unsteady
            << " that jump within 1/50 pixel, " << tally.wrong << " wrong; at most " << tally.worst_pixel
            << " pixel and " << tally.worst_depth << " of the depth's slack off\n";
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.hits, 1300);
  EXPECT_LT(tally.unsteady, tally.hits / 10);
}

INSTANTIATE_TEST_SUITE_P(Every, Camera, ::testing::ValuesIn(testing::views()),
                         [](const auto& info) { return testing::test_name(info.param); });

TEST(Cameras, NoPixelDiffersFromTheOracleAtItsOwnColumnAndRow) {
  Engine engine = testing::make_engine();
  double compared = 0;
  double mismatches = 0;
  double shadowed = 0;
  for (const Seen& seen : views()) {
    scene::Scene scene = testing::scene_of(seen);
    // Of 333 samples the coarsest level is 9; one below 0 is "auto".
    for (int q = -1; q <= 9; ++q) {
      scene.shadow.q = q < 0 ? std::nullopt : std::optional(q);
      const auto result = testing::compare_with_oracle(engine, scene);
      ASSERT_TRUE(result.ok()) << to_string(result.diagnostics().front());
      EXPECT_TRUE(result->verdict.passed) << seen.name << " q " << q << ": " << result->verdict.measured;
      compared += result->verdict.compared;
      mismatches += result->verdict.mismatches;
      for (const float b : result->rendered.image.channels.at("b_shadow")) shadowed += double{b};
    }
  }
  std::cout << "cameras: " << compared << " pixels, " << mismatches << " differ, " << shadowed
            << " in shadow\n";
  EXPECT_GT(compared, 1e6);
  EXPECT_GT(shadowed, 0.1 * compared);
  EXPECT_LT(shadowed, 0.9 * compared);
}

/// Twenty views from all around and from several heights, every other one with parallel rays.
std::vector<ViewCamera> twenty_cameras() {
  std::vector<ViewCamera> cameras;
  for (int i = 0; i < 20; ++i) {
    const double turn = 0.1 + 0.3 * i;  // radians
    const double away = 1800 + 150 * (i % 5);
    const Point eye{1660 + away * std::cos(turn), 1000 + away * std::sin(turn), 700.0 + 260 * (i % 4)};
    const Point target{1660.0 + 40 * (i % 3), 1000.0 - 30 * (i % 4), 150};
    cameras.push_back(i % 2 == 0 ? perspective(eye, target, 40, {144, 90})
                                 : orthographic(eye, target, 1300, {144, 90}));
  }
  return cameras;
}

/// Renders what a view saw again as points, by way of a file, and counts the points; bit for bit the same is
/// expected.
void ask_again(Engine& engine, const scene::Scene& seen, const std::string& file, Tally& tally) {
  const Result<Rendered> view = engine.render(seen);
  ASSERT_TRUE(view.ok()) << to_string(view.diagnostics().front());
  ASSERT_TRUE(image::write_exr(file, view->image).ok());
  scene::Scene scene = seen;
  scene.camera = scene::PointsCamera{.path = file, .below_root = {}};
  const Result<Rendered> points = engine.render(scene);
  ASSERT_TRUE(points.ok()) << to_string(points.diagnostics().front());
  for (const char* channel : {"valid", "q", "b_shadow"}) {
    const std::vector<float>&before = view->image.channels.at(channel),
          &after = points->image.channels.at(channel);
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i)
      tally.wrong += std::bit_cast<std::uint32_t>(before[i]) != std::bit_cast<std::uint32_t>(after[i]);
  }
  for (std::size_t i = 0; i < view->image.pixels(); ++i) {
    tally.hits += view->image.channels.at("valid")[i] != 0;
    tally.shadowed += view->image.channels.at("b_shadow")[i] != 0;
  }
}

TEST(Cameras, WhatTwentyOfThemSawHasTheSameShadowWhenAskedAgain) {
  Engine engine = testing::make_engine();
  const std::string file = ::testing::TempDir() + "gnomon_twenty_cameras.exr";
  long asked = 0;
  long shadowed = 0;
  int index = 0;
  for (const char* map : {"fractal", "gorge"}) {
    scene::Scene scene = testing::scene_over(map, 333, 200);
    scene.sun = {203.7, 12};
    for (const ViewCamera& camera : twenty_cameras()) {
      scene.camera = camera;
      scene.shadow.q = std::array<std::optional<int>, 4>{0, 1, 2, std::nullopt}[std::size_t(index++ % 4)];
      Tally tally;
      ask_again(engine, scene, file, tally);
      EXPECT_EQ(tally.wrong, 0) << map << ", camera " << index;
      asked += tally.hits;
      shadowed += tally.shadowed;
    }
  }
  std::filesystem::remove(file);
  std::cout << "asked again: " << asked << " points, " << shadowed << " in shadow\n";
  EXPECT_GT(asked, 200000);
  EXPECT_GT(shadowed, asked / 10);
  EXPECT_LT(shadowed, asked * 9 / 10);
}

}  // namespace
}  // namespace gnomon
