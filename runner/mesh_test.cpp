// SPDX-License-Identifier: MIT
// What cameras see of the surface drawn as a mesh, held against double-precision rays and the oracle; and
// cascaded shadow maps over it, which have to fail where they are known to and nowhere else.
#include "technique/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "oracle/mesh_ray.h"
#include "technique/camera.h"
#include "technique/cascades.h"
#include "technique/casters.h"
#include "technique/surface.h"
#include "testing/engine_fixture.h"
#include "testing/view_check.h"
#include "testing/views.h"

namespace gnomon {
namespace {

using testing::Seen;

scene::Scene mesh_scene(const Seen& seen, scene::MeshSurface mesh) {
  scene::Scene scene = testing::scene_of(seen);
  std::get<scene::ViewCamera>(scene.camera).mesh = mesh;
  return scene;
}

struct Tally {
  long hits = 0, unsteady = 0, wrong = 0;
};

Tally check(const Rendered& rendered, const scene::ViewCamera& camera) {
  const oracle::Surface surface = technique::surface_of(*rendered.map);
  const oracle::MeshTracer tracer(surface, camera.mesh->step, camera.mesh->cull_back_faces);
  const technique::CameraRays rays = technique::camera_rays(camera);
  const technique::Ground& ground = rendered.ground;
  Tally tally;
  for (std::size_t i = 0; i < ground.pixels(); i += 7) {
    const auto width = static_cast<std::size_t>(ground.size.x);
    const glm::dvec2 centre(double(i % width) + 0.5, double(i / width) + 0.5);
    const double depth = testing::true_depth(tracer, rays, centre);
    const double slack = testing::depth_slack(depth, *rendered.map);
    const bool steady = testing::is_steady(tracer, rays, centre, depth, slack);
    const double drawn = ground.valid[i] != 0 ? double{ground.depth[i]} : testing::kNowhere;
    tally.hits += depth < testing::kNowhere;
    tally.unsteady += !steady;
    tally.wrong += steady && !testing::agree(depth, drawn, slack);
  }
  return tally;
}

class Mesh : public ::testing::TestWithParam<Seen> {};

TEST_P(Mesh, IsDrawnWhereDoublePrecisionRaysMeetIt) {
  Engine engine = testing::make_engine();
  for (const scene::MeshSurface mesh :
       {scene::MeshSurface{.step = 1}, {.step = 5, .cull_back_faces = false}}) {
    const scene::Scene scene = mesh_scene(GetParam(), mesh);
    const Result<Rendered> rendered = engine.render(scene);
    ASSERT_TRUE(rendered.ok()) << to_string(rendered.diagnostics().front());
    const Tally tally = check(*rendered, std::get<scene::ViewCamera>(scene.camera));
    std::cout << GetParam().name << ", step " << mesh.step << ": " << tally.hits << " hits, "
              << tally.unsteady << " that jump within 1/50 pixel, " << tally.wrong << " wrong\n";
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.hits, 1300);
    EXPECT_LT(tally.unsteady, tally.hits / 10);
  }
}

INSTANTIATE_TEST_SUITE_P(Every, Mesh, ::testing::ValuesIn(testing::views()),
                         [](const auto& info) { return testing::test_name(info.param); });

TEST(Meshes, NoPixelDiffersFromTheOracleAtItsOwnColumnRowAndLevel) {
  Engine engine = testing::make_engine();
  double compared = 0;
  double mismatches = 0;
  int level = 0;
  for (const Seen& seen : testing::views()) {
    level = level % 9 + 1;  // one after the other up to the coarsest
    for (const std::optional<int> q : {std::optional(0), std::optional(level), std::optional<int>()}) {
      scene::Scene scene = mesh_scene(seen, {});
      scene.shadow.q = q;
      const auto result = testing::compare_with_oracle(engine, scene);
      ASSERT_TRUE(result.ok()) << to_string(result.diagnostics().front());
      EXPECT_TRUE(result->verdict.passed) << seen.name << ": " << result->verdict.measured;
      compared += result->verdict.compared;
      mismatches += result->verdict.mismatches;
    }
  }
  std::cout << "meshes: " << compared << " pixels, " << mismatches << " differ\n";
  EXPECT_GT(compared, 1e6);
}

/// The share of b_shadow that cascaded shadow maps get wrong.
double wrong_share(Engine& engine, scene::Scene scene, const scene::Cascades& cascades) {
  scene.shadow.method = "cascaded_shadow_maps";
  scene.shadow.cascades = cascades;
  const auto result = testing::compare_with_oracle(engine, scene);
  EXPECT_TRUE(result.ok()) << to_string(result.diagnostics().front());
  return result ? result->verdict.mismatches / result->verdict.compared : 1;
}

TEST(CascadedShadowMaps, ComeNearerToTheOracleTheFinerTheyAre) {
  Engine engine = testing::make_engine();
  const scene::Scene scene = mesh_scene(testing::views().front(), {});
  double coarser = 1;
  for (const int size : {128, 512, 2048}) {
    const double share = wrong_share(engine, scene, {.size = size});
    std::cout << "maps of " << size << ": " << 100 * share << " % wrong\n";
    EXPECT_LT(share, 0.7 * coarser);
    EXPECT_GT(share, 0) << "an approximation";
    coarser = share;
  }
  EXPECT_LT(coarser, 0.05) << "as good as its users get it";
}

TEST(CascadedShadowMaps, LoseWhatLiesBeyondTheirDistance) {
  Engine engine = testing::make_engine();
  const scene::Scene scene = mesh_scene(testing::views()[2], {});  // grazing
  const double whole = wrong_share(engine, scene, {.stable = false});
  EXPECT_GT(wrong_share(engine, scene, {.distance = 1000, .stable = false}), 3 * whole);
}

/// The share of a grid's cells in parts.
double share_of(const std::vector<gl::Mesh::Part>& parts, glm::ivec2 cells) {
  double drawn = 0;
  for (const gl::Mesh::Part& part : parts) drawn += double(part.cells.x) * part.cells.y;
  return drawn / (double(cells.x) * cells.y);
}

TEST(CascadedShadowMaps, HoldTheSameWhereTheyLeaveOutWhatLiesBesideThem) {
  Engine engine = testing::make_engine();
  double least = 1;
  for (const Seen& seen : testing::views()) {
    for (const scene::Sun& sun : {scene::Sun{200, 3}, scene::Sun{77, 40}, scene::Sun{10, 89.9}}) {
      scene::Scene scene = mesh_scene(seen, {});
      scene.sun = sun;
      scene.shadow.cascades = {.size = 512, .stable = false, .step = sun.elevation < 10 ? 1 : 3};
      const Result<Rendered> rendered = engine.render(scene);
      ASSERT_TRUE(rendered.ok()) << to_string(rendered.diagnostics().front());
      const auto some = engine.pyramid(rendered->map, 0, technique::Bounds::kCascades);
      ASSERT_TRUE(some.ok() && (*some)->height_ranges);
      const auto all = technique::build_pyramid(engine.programs(), *rendered->map, 0);
      ASSERT_TRUE(all.ok() && !all->height_ranges);
      const technique::CascadeFit fit = technique::fit_cascades(scene, rendered->ground, **some);
      const glm::ivec2 cells = technique::grid_cells(**some, scene.shadow.cascades.step);
      for (const technique::CascadeSquare& square : fit.squares)
        least = std::min(least, share_of(casters(**some, scene.shadow.cascades, fit, square), cells));
      double seconds = 0;
      const auto a = technique::draw_cascades(engine.programs(), **some, scene, rendered->ground, seconds);
      const auto b = technique::draw_cascades(engine.programs(), *all, scene, rendered->ground, seconds);
      ASSERT_TRUE(a.ok() && b.ok());
      EXPECT_EQ(a->nearness.download(), b->nearness.download()) << seen.name;
    }
  }
  std::cout << "the smallest share that a cascade drew: " << least << '\n';
  EXPECT_LT(least, 0.7) << "nothing was left out";
}

TEST(CascadedShadowMaps, OfAStableFitKeepTheirTexelsWhenTheCameraTurns) {
  Engine engine = testing::make_engine();
  std::vector<double> texels;
  for (const double turn : {0.0, 1.0, 2.0, 3.0}) {
    scene::Scene scene = mesh_scene(testing::views().front(), {});
    std::get<scene::ViewCamera>(scene.camera).target[0] += 20 * turn;
    const Result<Rendered> rendered = engine.render(scene);
    ASSERT_TRUE(rendered.ok());
    const Result<const technique::Pyramid*> pyramid = engine.pyramid(rendered->map, 0);
    ASSERT_TRUE(pyramid.ok());
    const technique::CascadeFit fit = technique::fit_cascades(scene, rendered->ground, **pyramid);
    ASSERT_EQ(fit.squares.size(), 4u);
    texels.push_back(fit.squares.front().texel);
    const glm::dvec2 corner = fit.squares.front().corner / fit.squares.front().texel;
    EXPECT_NEAR(corner.x, std::round(corner.x), 1e-6) << "whole texels";
    EXPECT_LE(fit.squares[0].texel, fit.squares[1].texel);
    EXPECT_LE(fit.squares[1].texel, fit.squares[2].texel);
  }
  EXPECT_EQ(texels, std::vector<double>(4, texels.front()));
}

/// A plain with one sample missing.
scene::Scene plain_with_hole(int column, int row, double azimuth) {
  scene::Scene scene;
  scene.id = scene.file = "hole";
  scene::InlineTerrain table{.width = 8, .height = 8, .heights = std::vector<double>(64, 5)};
  table.heights[static_cast<std::size_t>(row * 8 + column)] = scene::InlineTerrain::kNull;
  scene.terrain.source = table;
  scene.sun = {azimuth, 30};
  return scene;
}

TEST(CascadedShadowMaps, LeaveAPlainWithAHoleLit) {
  Engine engine = testing::make_engine();
  for (const double azimuth : {90.0, 250.0})
    for (const int step : {1, 4})
      EXPECT_EQ(wrong_share(engine, plain_with_hole(3, 3, azimuth), {.step = step}), 0)
          << "azimuth " << azimuth << ", step " << step;
}

TEST(Meshes, HaveTheHolesOfTheMapOnItsEdgesToo) {
  Engine engine = testing::make_engine();
  for (const auto& [column, row] : {std::pair(3, 3), {0, 3}, {7, 7}, {4, 0}}) {
    scene::Scene scene = plain_with_hole(column, row, 90);
    scene::ViewCamera camera = testing::orthographic({4, 4, 50}, {4, 4, 0}, 9, {180, 180});
    camera.mesh.emplace();
    scene.camera = camera;
    const Result<Rendered> rendered = engine.render(scene);
    ASSERT_TRUE(rendered.ok()) << to_string(rendered.diagnostics().front());
    const Tally tally = check(*rendered, camera);
    EXPECT_EQ(tally.wrong, 0) << column << ' ' << row;
    EXPECT_GT(tally.hits, 2500);
  }
}

TEST(CascadedShadowMaps, LoseTheStepsOfAnOpenModelWhereBackFacesAreLeftOut) {
  // The staircase has no wall where the map ends: the sun behind it sees the back of every rise.
  Engine engine = testing::make_engine();
  scene::Scene scene = testing::scene_over("steps", 200, 200);
  std::get<scene::ProceduralTerrain>(scene.terrain.source).parameters = {{"rise", 40}};
  scene.sun = {270, 5};
  const double all = wrong_share(engine, scene, {});
  const double front = wrong_share(engine, scene, {.faces = scene::Cascades::Faces::kFront});
  std::cout << "steps: " << 100 * all << " % wrong with all faces, " << 100 * front
            << " % with front faces\n";
  EXPECT_GT(front, 0.5);
  EXPECT_LT(all, 0.1);
}

}  // namespace
}  // namespace gnomon
