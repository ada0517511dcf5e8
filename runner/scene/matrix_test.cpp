// SPDX-License-Identifier: MIT
#include "scene/matrix.h"

#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

using MatrixTest = ScratchProject;
using SetTest = ScratchProject;
using Ids = std::vector<std::string>;

Ids ids(const LoadResult& result) {
  Ids all;
  for (const Diagnostic& diagnostic : result.diagnostics) all.push_back(to_string(diagnostic));
  for (const Scene& test : result.tests) all.push_back(test.id);
  return all;
}

TEST_F(MatrixTest, MakesOneTestForEachCombinationInTheOrderOfTheFile) {
  const LoadResult result = load(scene(R"("matrix": {"sun.elevation": [45, 1], "shadow.q": [0, 2]})"));
  EXPECT_EQ(ids(result),
            (Ids{"s@elevation=45,q=0", "s@elevation=45,q=2", "s@elevation=1,q=0", "s@elevation=1,q=2"}));
  EXPECT_EQ(result.tests[3].sun.elevation, 1);
  EXPECT_EQ(result.tests[3].shadow.q, 2);
  EXPECT_EQ(result.tests[3].golden_file, (root / "goldens/s@elevation=1,q=2.exr").generic_string());
}

TEST_F(MatrixTest, LabelsAreFitForFileNames) {
  EXPECT_EQ(ids(load(scene(R"("matrix": {"sun.azimuth": [0.1, -90, 1e21, 100000, 2.50]})"))),
            (Ids{"s@azimuth=0.1", "s@azimuth=-90", "s@azimuth=1e+21", "s@azimuth=100000", "s@azimuth=2.5"}));
  EXPECT_EQ(ids(load(scene(R"("matrix": {"description": ["a b/c", "é=,", "x_-.+9"]})"))),
            (Ids{"s@description=a_b_c", "s@description=___", "s@description=x_-.+9"}));
  EXPECT_EQ(ids(load(scene(R"("matrix": {"terrain": [{"procedural": "cone"}, {"heights": [[1]]}],
                                         "expect.0.golden.band": [true, false]})"))),
            (Ids{"s@terrain=#0,band=true", "s@terrain=#0,band=false", "s@terrain=#1,band=true",
                 "s@terrain=#1,band=false"}));
}

TEST_F(MatrixTest, TheWholeKeyTellsAxesApartThatEndAlike) {
  EXPECT_EQ(ids(load(scene(
                R"("matrix": {"terrain.size": [[8, 8]], "camera.map.size": [[4, 4]], "shadow.q": [1]})"))),
            Ids{"s@terrain.size=#0,camera.map.size=#0,q=1"});
}

TEST_F(MatrixTest, AnAxisMayLieInsideAnEarlierOne) {
  const LoadResult result = load(scene(
      R"("matrix": {"terrain": [{"procedural": "cone"}, {"procedural": "fractal"}], "terrain.size": [[8, 8], [16, 8]]})"));
  ASSERT_EQ(result.tests.size(), 4U);
  EXPECT_EQ(std::get<ProceduralTerrain>(result.tests[3].terrain.source).kind, "fractal");
  EXPECT_EQ(std::get<ProceduralTerrain>(result.tests[3].terrain.source).width, 16);
}

TEST_F(MatrixTest, MistakesAreLocatedAtTheEntry) {
  EXPECT_EQ(
      errors(scene("\"matrix\": {\"sun.elevation\": [10, 100, -100],\n\"shadow.q\": [0, 9]}")),
      "s.json:3:34: error: /matrix/sun.elevation/1: expected a number from -90 to 90 (degrees), got 100. "
      "Height of the sun above the horizon.\n"
      "s.json:3:39: error: /matrix/sun.elevation/2: expected a number from -90 to 90 (degrees), got -100. "
      "Height of the sun above the horizon.\n"
      "s.json:4:17: error: /matrix/shadow.q/1: level 9 does not exist; the coarsest level of a 256x256 map "
      "is "
      "L = 8");
}

TEST_F(MatrixTest, RefusesWhatGivesNoDistinctTests) {
  EXPECT_EQ(errors(scene("\"matrix\": {\"sun.elevation\": [10, 10.0]}")),
            "s.json:3:34: error: /matrix/sun.elevation/1: gives the same test id (\"10\") as entry 0; ids "
            "must differ");
  EXPECT_EQ(errors(scene("\"matrix\": {\"sun.elevation\": []}")),
            "s.json:3:29: error: /matrix/sun.elevation: expected a list of at least 1, got []. The values "
            "that the key "
            "takes.");
  EXPECT_EQ(errors(scene("\"matrix\": {\"sun.elevation\": 5}")),
            "s.json:3:29: error: /matrix/sun.elevation: expected a list of at least 1, got 5. The values "
            "that the key "
            "takes.");
  EXPECT_EQ(errors(scene("\"matrix\": {\"sun.elevation\": [1], \"sun.direction\": [[0, 0, 1]]}")),
            "s.json:3:12: error: /matrix/sun.elevation: a later axis of the matrix removes or replaces "
            "\"sun.elevation\"; keep one of the two");
  EXPECT_EQ(
      errors(scene("\"matrix\": {\"expect.1.max_steps\": [1]}")),
      "s.json:3:12: error: /matrix/expect.1.max_steps: \"1\" is none of this list's 1 entries (from 0)");
  EXPECT_EQ(errors(scene("\"matrix\": {\"version\": [1]}")),
            "s.json:3:12: error: /matrix/version: \"version\" is the same for all tests of a scene file");
  EXPECT_EQ(
      errors(scene("\"matrix\": {\"sun..x\": [1]}")),
      "s.json:3:12: error: /matrix/sun..x: expected a dotted key such as sun.elevation, got \"sun..x\"");
  EXPECT_EQ(
      errors(scene("\"matrix\": {\"sun.elevaton\": [1]}")),
      "s.json:3:29: error: /matrix/sun.elevaton/0: unknown key \"elevaton\"; did you mean \"elevation\"?");
}

TEST_F(MatrixTest, IsLimited) {
  std::string values = "0";
  for (int i = 1; i < 101; ++i) values += "," + std::to_string(i);
  const std::string axes = "\"sun.azimuth\": [" + values + "], \"terrain.seed\": [" + values + "]";
  EXPECT_EQ(errors(scene("\"matrix\": {" + axes + "}")),
            "s.json:3:11: error: /matrix: makes more than 10000 tests, or has more than 32 keys");
}

TEST_F(SetTest, OverridesAKeyAndReplacesItsAxis) {
  const std::string text =
      scene(R"("sun": {"elevation": 5}, "matrix": {"sun.elevation": [1, 2], "shadow.q": [0, 1]})");
  const LoadResult result = load(text, {"sun.elevation=7", "expect.0.max_steps=400"});
  EXPECT_EQ(ids(result), (Ids{"s@q=0", "s@q=1"}));
  EXPECT_EQ(result.tests[0].sun.elevation, 7);
  EXPECT_EQ(std::get<MaxStepsExpectation>(result.tests[0].expect.at(0)).limit, 400);
  EXPECT_EQ(result.tests[0].overrides, (Ids{"sun.elevation=7", "expect.0.max_steps=400"}));
}

TEST_F(SetTest, SettingOneAlternativeRemovesTheOther) {
  const std::string angles =
      scene(R"("sun": {"azimuth": 10, "elevation": 5}, "matrix": {"sun.azimuth": [1, 2]})");
  const LoadResult towards = load(angles, {"sun.direction=[1, 0, 1]"});
  EXPECT_EQ(ids(towards), Ids{"s"});
  EXPECT_DOUBLE_EQ(towards.tests[0].sun.azimuth, 90);
  EXPECT_DOUBLE_EQ(towards.tests[0].sun.elevation, 45);
  const LoadResult back = load(scene(R"("sun": {"direction": [0, 0, 1]})"), {"sun.elevation=5"});
  ASSERT_EQ(ids(back), Ids{"s"});
  EXPECT_EQ(back.tests[0].sun.azimuth, 315);
  EXPECT_EQ(back.tests[0].sun.elevation, 5);
  write("testcases/m.png", "x");
  const LoadResult file =
      load(scene("", R"({"procedural": "cone", "seed": 3, "spacing": 2})"), {"terrain.file=m.png"});
  ASSERT_EQ(ids(file), Ids{"s"});
  EXPECT_TRUE(std::holds_alternative<FileTerrain>(file.tests[0].terrain.source));
  EXPECT_EQ(file.tests[0].terrain.spacing, (std::array{2.0, 2.0}));
}

TEST_F(SetTest, ReadsTheValueAsJsonElseAsAString) {
  EXPECT_EQ(load(scene(), {"description=two words"}).tests.at(0).description, "two words");
  EXPECT_EQ(load(scene(), {"description=\"5\""}).tests.at(0).description, "5");
  EXPECT_EQ(load(scene(), {"description=a=b"}).tests.at(0).description, "a=b");
  EXPECT_EQ(errors(scene(), {"description=5"}),
            "--set description: error: /description: expected a string that is not empty, got 5. One "
            "sentence for a "
            "person: what the scene shows and why the answer is known.");
}

TEST_F(SetTest, MistakesAreLocatedAtTheArgument) {
  EXPECT_EQ(errors(scene(), {"sun.elevation=100"}),
            "--set sun.elevation: error: /sun/elevation: expected a number from -90 to 90 (degrees), got "
            "100. Height "
            "of the sun above the horizon.");
  EXPECT_EQ(errors(scene(), {"sunn.elevation=1"}),
            "--set sunn.elevation: error: /sunn: unknown key \"sunn\"; did you mean \"sun\"?");
  EXPECT_EQ(errors(scene(), {"shadow.q=10"}),
            "--set shadow.q: error: /shadow/q: level 10 does not exist; the coarsest level of a 256x256 map "
            "is L = 8");
  EXPECT_EQ(errors(scene(), {"sun"}), "--set sun: error: expected KEY=VALUE, such as sun.elevation=5");
  EXPECT_EQ(errors(scene(), {"=5"}), "--set : error: expected a dotted key such as sun.elevation, got \"\"");
  EXPECT_EQ(errors(scene(), {"description.x=5"}),
            "--set description.x: error: /description/x: \"x\" would lie inside \"d\", which is no object");
  EXPECT_EQ(
      errors(scene(), {"expect.7.golden={}"}),
      "--set expect.7.golden: error: /expect/7/golden: \"7\" is none of this list's 1 entries (from 0)");
  EXPECT_EQ(errors(scene("", R"({"heights": [[1]]})"), {"terrain.seed=5"}),
            "--set terrain.seed: error: /terrain/seed: \"seed\" does not go together with \"heights\": give "
            "one or the "
            "other");
}

TEST_F(SetTest, WinsInsideAMatrixValueToo) {
  const LoadResult result =
      load(scene(R"("matrix": {"terrain": [{"procedural": "cone"}, {"procedural": "fractal"}]})"),
           {"terrain.seed=9"});
  ASSERT_EQ(ids(result), (Ids{"s@terrain=#0", "s@terrain=#1"}));
  EXPECT_EQ(std::get<ProceduralTerrain>(result.tests[1].terrain.source).seed, 9U);
}

}  // namespace
}  // namespace gnomon::scene
