// SPDX-License-Identifier: MIT
// Paths: key frames of the sun and the camera.
#include "scene/frames.h"

#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

using FramesTest = ScratchProject;
using Ids = std::vector<std::string>;
using Point = std::array<double, 3>;

Ids ids(const LoadResult& result) {
  Ids all;
  for (const Diagnostic& diagnostic : result.diagnostics) all.push_back(to_string(diagnostic));
  for (const Scene& test : result.tests) all.push_back(test.id);
  return all;
}

std::vector<double> azimuths(const LoadResult& result) {
  std::vector<double> all;
  for (const Scene& test : result.tests) all.push_back(test.sun.azimuth);
  return all;
}

std::vector<double> elevations(const LoadResult& result) {
  std::vector<double> all;
  for (const Scene& test : result.tests) all.push_back(test.sun.elevation);
  return all;
}

const ViewCamera& view(const Scene& test) {
  return std::get<ViewCamera>(test.camera);
}

constexpr const char* kView =
    R"("camera": {"perspective": {"eye": [0, 0, 100], "target": [50, 50, 0], "fov": 40}})";

TEST_F(FramesTest, EachMakesATest) {
  const LoadResult result =
      load(scene(R"("frames": {"count": 3, "keys": [{"frame": 2, "sun": {"elevation": 65}}]})"));
  EXPECT_EQ(ids(result), (Ids{"s@frame=0000", "s@frame=0001", "s@frame=0002"}));
  EXPECT_EQ(result.tests[1].golden_file, (root / "goldens/s@frame=0001.exr").generic_string());
  EXPECT_EQ(result.tests[1].frame->number, 1);
  EXPECT_EQ(result.tests[1].frame->count, 3);
  EXPECT_EQ(result.tests[1].frame->rate, 10);
  EXPECT_FALSE(load(scene()).tests.at(0).frame);
}

TEST_F(FramesTest, StartFromTheSceneAndStayAfterTheLastKey) {
  const LoadResult result = load(scene(
      R"("sun": {"elevation": 5}, "frames": {"count": 6, "keys": [{"frame": 2, "sun": {"elevation": 6}},
         {"frame": 4, "sun": {"elevation": 10}}]})"));
  EXPECT_EQ(elevations(result), (std::vector<double>{5, 5.5, 6, 8, 10, 10}));
  EXPECT_EQ(azimuths(result), std::vector<double>(6, 315)) << "what no key names stands still";
  const LoadResult early = load(scene(
      R"("sun": {"elevation": 5}, "frames": {"count": 3, "keys": [{"frame": 0, "sun": {"elevation": 20}}]})"));
  EXPECT_EQ(elevations(early), std::vector<double>(3, 20)) << "a key for frame 0 takes the scene's place";
  EXPECT_EQ(
      elevations(load(scene(R"("frames": {"count": 3, "keys": [{"frame": 2, "sun": {"elevation": 25}}]})"))),
      (std::vector<double>{45, 35, 25}))
      << "from the default";
}

TEST_F(FramesTest, AzimuthsTakeTheShorterArc) {
  const auto path = [&](const std::string& from, const std::string& to) {
    return azimuths(load(scene(
        "\"sun\": {\"azimuth\": " + from +
        "}, \"frames\": {\"count\": 3, \"keys\": [{\"frame\": 2, \"sun\": {\"azimuth\": " + to + "}}]}")));
  };
  EXPECT_EQ(path("350", "20"), (std::vector<double>{350, 5, 20}));
  EXPECT_EQ(path("20", "350"), (std::vector<double>{20, 5, 350}));
  EXPECT_EQ(path("90", "270"), (std::vector<double>{90, 180, 270})) << "clockwise where both are equal";
  EXPECT_EQ(path("270", "90"), (std::vector<double>{270, 0, 90}));
  EXPECT_EQ(path("-10", "730"), (std::vector<double>{350, 0, 10}));
}

TEST_F(FramesTest, CamerasMoveOnStraightLines) {
  const LoadResult result = load(scene(std::string(kView) + R"(, "frames": {"count": 5, "keys": [
        {"frame": 1, "camera": {"fov": 20}},
        {"frame": 4, "camera": {"eye": [40, -80, 60], "target": [90, 50, 0], "fov": 50}}]})"));
  ASSERT_EQ(listing(result), "");
  EXPECT_EQ(view(result.tests[0]).eye, (Point{0, 0, 100}));
  EXPECT_EQ(view(result.tests[0]).extent, 40);
  EXPECT_EQ(view(result.tests[1]).eye, (Point{10, -20, 90}));
  EXPECT_EQ(view(result.tests[1]).extent, 20);
  EXPECT_EQ(view(result.tests[2]).target, (Point{70, 50, 0}));
  EXPECT_EQ(view(result.tests[2]).extent, 30);
  EXPECT_EQ(view(result.tests[4]).eye, (Point{40, -80, 60}));
  EXPECT_EQ(view(result.tests[4]).extent, 50);
}

constexpr const char* kTwo =
    R"("cameras": {"near": {"perspective": {"eye": [0, 0, 9], "target": [5, 5, 0]}},
       "far": {"orthographic": {"eye": [0, 0, 9], "target": [5, 5, 0], "height": 50}}})";

TEST_F(FramesTest, RunFasterThanCamerasAndMatrix) {
  const LoadResult result = load(scene(
      std::string(kTwo) + R"(, "matrix": {"shadow.q": [0, 1]}, "frames": {"count": 2, "rate": 25, "keys": [
        {"frame": 1, "cameras": {"near": {"fov": 30}, "far": {"height": 70}}}]})"));
  ASSERT_EQ(ids(result), (Ids{"s@camera=near,q=0,frame=0000", "s@camera=near,q=0,frame=0001",
                              "s@camera=near,q=1,frame=0000", "s@camera=near,q=1,frame=0001",
                              "s@camera=far,q=0,frame=0000", "s@camera=far,q=0,frame=0001",
                              "s@camera=far,q=1,frame=0000", "s@camera=far,q=1,frame=0001"}));
  EXPECT_EQ(view(result.tests[2]).extent, 45);
  EXPECT_EQ(view(result.tests[3]).extent, 30);
  EXPECT_EQ(result.tests[3].shadow.q, 1);
  EXPECT_EQ(view(result.tests[5]).extent, 70);
  EXPECT_EQ(result.tests[5].frame->rate, 25);
}

TEST_F(FramesTest, AMatrixMaySetWhereThePathStarts) {
  const LoadResult result = load(scene(
      R"("matrix": {"sun.elevation": [10, 20]}, "frames": {"count": 3, "keys": [{"frame": 2, "sun": {"elevation": 30}}]})"));
  EXPECT_EQ(elevations(result), (std::vector<double>{10, 20, 30, 20, 25, 30}));
}

TEST_F(FramesTest, OverridesChangeThePathOrHoldStill) {
  const std::string text = scene(
      std::string(kView) +
      R"(, "frames": {"count": 3, "keys": [{"frame": 2, "sun": {"elevation": 65}, "camera": {"fov": 60}}]})");
  EXPECT_EQ(elevations(load(text, {"frames.keys.0.sun.elevation=85"})), (std::vector<double>{45, 65, 85}));
  EXPECT_EQ(load(text, {"frames.count=5"}).tests.size(), 5U);
  EXPECT_EQ(elevations(load(text, {"sun.elevation=7"})), (std::vector<double>{7, 7, 7}));
  const LoadResult map = load(text, {"camera={\"map\": {}}"});
  ASSERT_EQ(map.tests.size(), 3U);
  EXPECT_TRUE(std::holds_alternative<MapCamera>(map.tests[2].camera));
  EXPECT_EQ(map.tests[2].overrides, std::vector<std::string>{"camera={\"map\": {}}"});
}

TEST_F(FramesTest, KeysThatMakeNoPathAreErrors) {
  EXPECT_EQ(
      errors(scene("\"frames\": {\"count\": 3, \"keys\": [{\"frame\": 3, \"sun\": {\"azimuth\": 1}},\n"
                   "{\"frame\": 1, \"sun\": {\"azimuth\": 1}}, {\"frame\": 2, \"sun\": {}}]}")),
      "s.json:3:43: error: /frames/keys/0/frame: there is no such frame; with a count of 3 the last one is "
      "2\n"
      "s.json:4:11: error: /frames/keys/1/frame: frames have to rise from key to key; the key before is for "
      "frame 3\n"
      "s.json:4:38: error: /frames/keys/2: the key moves nothing; expected \"sun\", \"camera\" or "
      "\"cameras\" "
      "with what changes\n"
      "s.json:4:48: error: /frames/keys/2/frame: frames have to rise from key to key; the key before is for "
      "frame 3");
  EXPECT_EQ(
      errors(scene("\"frames\": {\"count\": 0, \"keys\": [{\"frame\": 0, \"sun\": {\"elevation\": 91}}]}")),
      "s.json:3:21: error: /frames/count: expected an integer from 1 to 10000 (frames), got 0. How many "
      "frames "
      "there are, from 0 to count - 1.\n"
      "s.json:3:67: error: /frames/keys/0/sun/elevation: expected a number from -90 to 90 (degrees), got 91. "
      "As "
      "sun.elevation.");
  EXPECT_EQ(errors(scene("\"frames\": {\"count\": 2}")),
            "s.json:3:11: error: /frames: missing key \"keys\". Key frames. What a key does not name goes on "
            "from the "
            "key before to the next one that names it; frame 0 is the scene as it is written, unless a key "
            "for it says "
            "otherwise.");
  EXPECT_EQ(errors(scene("\"frames\": {\"count\": 2, \"keys\": [{\"frame\": 1, \"camera\": {\"fow\": 5}}]}")),
            "s.json:3:57: error: /frames/keys/0/camera/fow: unknown key \"fow\"; did you mean \"fov\"?");
  EXPECT_EQ(errors(scene("\"matrix\": {\"frames.count\": [2]}")),
            "s.json:3:12: error: /matrix/frames.count: \"frames\" makes tests itself, the same for all "
            "values of the "
            "matrix");
}

TEST_F(FramesTest, WhatCannotBeMovedIsSaidAtTheKey) {
  const auto path = [](const std::string& key) {
    return "\"frames\": {\"count\": 2, \"keys\": [{\"frame\": 1, " + key + "}]}";
  };
  EXPECT_EQ(errors(scene(path(R"("camera": {"fov": 5})"))),
            "s.json:3:64: error: /frames/keys/0/camera/fov: only a perspective or orthographic camera can be "
            "moved");
  EXPECT_EQ(
      errors(scene(std::string(kView) + ",\n" + path(R"("camera": {"height": 5})"))),
      "s.json:4:67: error: /frames/keys/0/camera/height: this camera is perspective and has no \"height\"");
  EXPECT_EQ(
      errors(scene("\"sun\": {\"direction\": [1, 0, 1]},\n" + path(R"("sun": {"azimuth": 5})"))),
      "s.json:4:65: error: /frames/keys/0/sun/azimuth: frames move a sun that is given by \"azimuth\" and "
      "\"elevation\"; write the scene's sun so");
  EXPECT_EQ(
      errors(scene(std::string(kTwo) + ",\n" + path(R"("camera": {"eye": [1, 2, 3]})"))),
      "s.json:5:46: error: /frames/keys/0/camera: the scene has several cameras; say which one: \"cameras\": "
      "{NAME: ...}");
  EXPECT_EQ(errors(scene(std::string(kTwo) + ",\n" + path(R"("cameras": {"nea": {"eye": [1, 2, 3]}})"))),
            "s.json:5:58: error: /frames/keys/0/cameras/nea: unknown camera \"nea\"; did you mean \"near\"?");
  EXPECT_EQ(errors(scene(std::string(kView) + ",\n" + path(R"("cameras": {"a": {"eye": [1, 2, 3]}})"))),
            "s.json:4:46: error: /frames/keys/0/cameras: the scene has one camera without a name; write "
            "\"camera\": "
            "{...}");
}

TEST_F(FramesTest, MistakesOnTheWayNameTheFrameOrTheKey) {
  EXPECT_EQ(
      errors(scene(std::string(kView) + ",\n" + R"("frames": {"count": 3, "keys": [
       {"frame": 2, "camera": {"eye": [100, 100, -100]}}]})")),
      "s.json:5:39: error: /frames/keys/0/camera/eye: in frame 1 the camera's eye and target are the same "
      "point; keep them apart with a key between");
  EXPECT_EQ(errors(scene(
                "\"matrix\": {\"sun.elevation\": [1, 2]},\n\"frames\": {\"count\": 2, \"keys\": [{\"frame\": "
                "0, \"sun\": {\"elevation\": 5}}]}")),
            "s.json:3:12: error: /matrix/sun.elevation: the key for frame 0 sets \"sun.elevation\" too; keep "
            "one of "
            "the two");
  EXPECT_EQ(errors(scene(
                R"("sun": {"elevation": "low"}, "camera": {"perspective": {"eye": 5, "target": [0, 0, "x"]}},
      "frames": {"count": 2, "keys": [{"frame": 1, "sun": {"elevation": 5}, "camera": {"eye": [1, 1, 1], "target": [1, 2, 3]}}]})")),
            "s.json:3:22: error: /sun/elevation: expected a number from -90 to 90 (degrees), got \"low\". "
            "Height of "
            "the sun above the horizon.\n"
            "s.json:3:64: error: /camera/perspective/eye: expected a list of exactly 3, each a number from "
            "-10000000.0 to 10000000.0 (m), got 5. Where the camera stands: [x, y, z], x east and y "
            "north of the "
            "map's south-west corner, z above height 0.\n"
            "s.json:3:84: error: /camera/perspective/target/2: expected a number from -10000000.0 to "
            "10000000.0, "
            "got \"x\"");
}

TEST_F(FramesTest, CountAmongTheTestsOfAScene) {
  const std::string keys = "\"keys\": [{\"frame\": 1, \"sun\": {\"azimuth\": 5}}]}";
  EXPECT_EQ(errors(scene("\"matrix\": {\"shadow.q\": [0, 1]},\n\"frames\": {\"count\": 5001, " + keys)),
            "s.json:3:11: error: /matrix: makes more than 10000 tests, or has more than 32 keys");
  const LoadResult most = load(scene("\"frames\": {\"count\": 10000, " + keys));
  ASSERT_EQ(most.tests.size(), 10000U);
  EXPECT_EQ(most.tests.back().id, "s@frame=9999");
}

}  // namespace
}  // namespace gnomon::scene
