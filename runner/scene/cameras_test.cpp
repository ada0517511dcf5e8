// SPDX-License-Identifier: MIT
// Several cameras in one scene.
#include "scene/matrix.h"
#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

using CamerasTest = ScratchProject;
using Ids = std::vector<std::string>;

Ids ids(const LoadResult& result) {
  Ids all;
  for (const Diagnostic& diagnostic : result.diagnostics) all.push_back(to_string(diagnostic));
  for (const Scene& test : result.tests) all.push_back(test.id);
  return all;
}

constexpr const char* kCameras =
    "\"cameras\": {\n"
    "\"ridge\": {\"perspective\": {\"eye\": [0, 0, 9], \"target\": [5, 5, 0]}},\n"
    "\"far\": {\"orthographic\": {\"eye\": [0, 0, 9], \"target\": [5, 5, 0], \"height\": 50}},\n"
    "\"map\": {\"map\": {}}}";

TEST_F(CamerasTest, EachMakesATestInTheOrderOfTheFile) {
  const LoadResult result = load(scene(kCameras));
  ASSERT_EQ(ids(result), (Ids{"s@camera=ridge", "s@camera=far", "s@camera=map"}));
  EXPECT_EQ(std::get<ViewCamera>(result.tests[0].camera).extent, 45);
  EXPECT_EQ(std::get<ViewCamera>(result.tests[1].camera).extent, 50);
  EXPECT_TRUE(std::holds_alternative<MapCamera>(result.tests[2].camera));
  EXPECT_EQ(result.tests[1].golden_file, (root / "goldens/s@camera=far.exr").generic_string());
  EXPECT_NE(result.tests[0].canonical_json, result.tests[1].canonical_json);
  EXPECT_EQ(result.tests[2].canonical_json, load(scene()).tests.at(0).canonical_json);
}

TEST_F(CamerasTest, AMatrixRunsFasterAndMayChangeTheCameraOfEach) {
  const LoadResult result = load(scene(
      R"("cameras": {"a": {"map": {}}, "b": {"map": {"size": [9, 9]}}}, "matrix": {"camera.map.size": [[4, 3], [8, 6]]})"));
  ASSERT_EQ(ids(result),
            (Ids{"s@camera=a,size=#0", "s@camera=a,size=#1", "s@camera=b,size=#0", "s@camera=b,size=#1"}));
  EXPECT_EQ(std::get<MapCamera>(result.tests[3].camera).size, (std::array{8, 6}));
}

TEST_F(CamerasTest, OverridesReachOneCameraOrAllOrTakeTheirPlace) {
  const LoadResult one = load(scene(kCameras), {"cameras.ridge.perspective.fov=30"});
  ASSERT_EQ(one.tests.size(), 3U);
  EXPECT_EQ(std::get<ViewCamera>(one.tests[0].camera).extent, 30);
  const std::string two = scene(R"("cameras": {"a": {"map": {}}, "b": {"map": {}}})");
  for (const Scene& test : load(two, {"camera.map.size=[7, 5]"}).tests)
    EXPECT_EQ(std::get<MapCamera>(test.camera).size, (std::array{7, 5}));
  EXPECT_EQ(ids(load(two, {"camera={\"map\": {}}"})), Ids{"s"});
  EXPECT_EQ(ids(load(two, {"cameras.c={\"map\": {}}"})), (Ids{"s@camera=a", "s@camera=b", "s@camera=c"}));
  EXPECT_EQ(ids(load(scene(R"("camera": {"map": {"size": [3, 3]}})"), {"cameras.c.map={}"})),
            Ids{"s@camera=c"});
}

TEST_F(CamerasTest, MistakesAreLocatedAtTheCamera) {
  EXPECT_EQ(
      errors(scene("\"cameras\": {\"a\": {\"map\": {}},\n\"b\": {\"map\": {\"size\": [0, 1]}},\n"
                   "\"c\": {\"perspective\": {\"eye\": [1, 2, 3], \"target\": [1, 2, 3]}},\n"
                   "\"d\": {\"mapp\": {}},\n\"e\": 5}")),
      "s.json:4:24: error: /cameras/b/map/size/0: expected an integer from 1 to 16384, got 0\n"
      "s.json:5:51: error: /cameras/c/perspective/target: the target is the eye itself; expected a point in "
      "the middle of the image, a micrometre or more away\n"
      "s.json:6:7: error: /cameras/d/mapp: unknown key \"mapp\"; did you mean \"map\"?\n"
      "s.json:7:6: error: /cameras/e: expected an object with \"map\", or an object with \"perspective\", or "
      "an "
      "object with \"orthographic\", or an object with \"points\", got 5. Which points are asked for their "
      "shadow.");
  EXPECT_EQ(
      errors(scene("\"cameras\": {}")),
      "s.json:3:12: error: /cameras: expected an object, got {}. Several cameras by name, instead of camera: "
      "each makes a test of its own.");
  EXPECT_EQ(errors(scene("\"cameras\": [1]")),
            "s.json:3:12: error: /cameras: expected an object, got [1]. Several cameras by name, instead of "
            "camera: "
            "each makes a test of its own.");
  EXPECT_EQ(errors(scene(kCameras), {"cameras.far.orthographic.height=-1"}),
            "--set cameras.far.orthographic.height: error: /cameras/far/orthographic/height: expected a "
            "number above 0 "
            "(m), got -1. Distance from the top of the image to its bottom, across the rays.");
}

TEST_F(CamerasTest, RefusesWhatGivesNoDistinctTests) {
  EXPECT_EQ(errors(scene("\"camera\": {\"map\": {}},\n\"cameras\": {\"a\": {\"map\": {}}}")),
            "s.json:4:12: error: /cameras: \"cameras\" does not go together with \"camera\": give one or the "
            "other");
  EXPECT_EQ(errors(scene("\"cameras\": {\"a b\": {\"map\": {}}, \"a_b\": {\"map\": {}}}")),
            "s.json:3:40: error: /cameras/a_b: gives the same test id (\"a_b\") as entry 0; ids must differ");
  EXPECT_EQ(errors(scene("\"cameras\": {\"\": {\"map\": {}}}")),
            "s.json:3:13: error: /cameras/: expected a name for the camera");
  EXPECT_EQ(
      errors(scene("\"cameras\": {\"a\": {\"map\": {}}},\n\"matrix\": {\"cameras.a.map.size\": [[1, 1]]}")),
      "s.json:4:12: error: /matrix/cameras.a.map.size: \"cameras\" makes tests itself; the matrix may change "
      "the camera of each, with keys of \"camera\"");
  EXPECT_EQ(
      errors(scene("\"cameras\": {\"a\": {\"map\": {}}},\n\"matrix\": {\"camera\": [{\"map\": {}}]}")),
      "s.json:3:12: error: /cameras: a later axis of the matrix removes or replaces \"camera\"; keep one of "
      "the two");
}

TEST_F(CamerasTest, CountAmongTheTestsOfAScene) {
  std::string cameras, values = "0";
  for (int i = 0; i < 101; ++i) cameras += (i ? ", \"" : "\"") + std::to_string(i) + "\": {\"map\": {}}";
  for (int i = 1; i < 100; ++i) values += "," + std::to_string(i);
  EXPECT_EQ(errors(scene("\"cameras\": {" + cameras + "},\n\"matrix\": {\"sun.azimuth\": [" + values + "]}")),
            "s.json:4:11: error: /matrix: makes more than 10000 tests, or has more than 32 keys");
}

}  // namespace
}  // namespace gnomon::scene
