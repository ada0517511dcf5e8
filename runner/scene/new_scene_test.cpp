// SPDX-License-Identifier: MIT
#include "scene/new_scene.h"

#include <cmath>
#include <numbers>

#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

using NewScene = ScratchProject;

TEST_F(NewScene, BringsWhatTheProjectLacksAndLoads) {
  std::filesystem::remove(root / "gnomon.json");
  const auto files = new_scene("area/first", root.generic_string());
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 3U);
  EXPECT_EQ((*files)[0].path, (root / "testcases/area/first.json").generic_string());
  EXPECT_EQ((*files)[1].path, (root / "gnomon.json").generic_string());
  EXPECT_EQ((*files)[2].path, (root / "scene.schema.json").generic_string());
  EXPECT_NE((*files)[0].text.find("\"$schema\": \"../../scene.schema.json\""), std::string::npos);
  for (const NewFile& file : *files) {
    std::filesystem::create_directories(std::filesystem::path(file.path).parent_path());
    std::ofstream(file.path) << file.text;
  }
  const LoadResult result = load_scene((*files)[0].path, {}, vocabulary);
  EXPECT_EQ(listing(result), "");
  ASSERT_EQ(result.tests.size(), 1U);
  EXPECT_EQ(result.tests[0].id, "area/first");

  EXPECT_EQ(new_scene("second", root.generic_string())->size(), 1U) << "only the scene is new";
  const auto again = new_scene("area/first.json", root.generic_string());
  ASSERT_FALSE(again);
  EXPECT_EQ(again.diagnostics()[0].message, "the scene exists already; choose another name or remove it");
}

/// A wall of height H casts its shadow H / tan(elevation) far, away from the sun.
TEST_F(NewScene, ExpectsTheShadowOfItsWall) {
  const LoadResult result = load(new_scene_text("../scene.schema.json"));
  ASSERT_EQ(result.tests.size(), 1U);
  const Scene& test = result.tests[0];
  const auto& terrain = std::get<InlineTerrain>(test.terrain.source);
  const auto highest = std::max_element(terrain.heights.begin(), terrain.heights.begin() + terrain.width);
  const double wall = static_cast<double>(highest - terrain.heights.begin());
  const double length = *highest / std::tan(test.sun.elevation * std::numbers::pi / 180);
  ASSERT_EQ(test.sun.azimuth, 270);
  int probes = 0;
  for (const Expectation& expectation : test.expect) {
    const auto* probe = std::get_if<ProbeExpectation>(&expectation);
    if (!probe) continue;
    ++probes;
    EXPECT_EQ(probe->values.at("b_shadow"), probe->x > wall && probe->x - wall < length ? 1 : 0) << probe->x;
    EXPECT_GT(std::abs(probe->x - wall - length), 0.1) << "a probe in the band decides nothing";
  }
  EXPECT_GE(probes, 4);
}

TEST_F(NewScene, RefusesNamesThatAreNoPlainPaths) {
  for (const char* name :
       {"", "/a", "../a", "a/../b", "a//b", "a/", ".a", "a b", "a\\b", "é", "a/.json", ".json"}) {
    EXPECT_FALSE(new_scene(name, root.generic_string())) << name;
  }
}

}  // namespace
}  // namespace gnomon::scene
