// SPDX-License-Identifier: MIT
// Paths: key frames of the sun and the camera.
#include "scene/frames.h"

#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

struct FramesTest : ScratchProject {
  using ScratchProject::scene;
};
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
      "s.json:4:65: error: /frames/keys/0/sun/azimuth: \"azimuth\" moves a sun that is given by \"azimuth\" "
      "and \"elevation\", and the scene gives its sun by \"direction\": give both in the same way");
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

/// A scene on the equator with its sun at this time, and a path of `count` frames with these keys.
std::string timed(const std::string& time, int count, const std::string& keys,
                  const std::string& more = R"(, "latitude": 0, "longitude": 10)") {
  return FramesTest::scene("\"sun\": {\"time\": \"" + time + "\"" + more + "},\n\"frames\": {\"count\": " +
                           std::to_string(count) + ", \"keys\": [" + keys + "]}");
}

std::string time_key(int frame, const std::string& time) {
  return "{\"frame\": " + std::to_string(frame) + ", \"sun\": {\"time\": \"" + time + "\"}}";
}

Ids times(const LoadResult& result) {
  Ids all;
  for (const Diagnostic& diagnostic : result.diagnostics) all.push_back(to_string(diagnostic));
  for (const Scene& test : result.tests) all.push_back(ephemeris::to_string(test.sun.time.value().time));
  return all;
}

TEST_F(FramesTest, ATimeGoesByEvenlyFromKeyToKey) {
  EXPECT_EQ(
      times(load(timed("2024-06-21T06:00:00Z", 6,
                       time_key(2, "2024-06-21T18:00:00Z") + "," + time_key(4, "2024-06-21T18:01:00Z")))),
      (Ids{"2024-06-21T06:00:00Z", "2024-06-21T12:00:00Z", "2024-06-21T18:00:00Z", "2024-06-21T18:00:30Z",
           "2024-06-21T18:01:00Z", "2024-06-21T18:01:00Z"}));
  EXPECT_EQ(
      times(load(timed("2024-06-21T23:00:00Z", 4, time_key(3, "2024-06-22T05:00:00Z")))),
      (Ids{"2024-06-21T23:00:00Z", "2024-06-22T01:00:00Z", "2024-06-22T03:00:00Z", "2024-06-22T05:00:00Z"}));
  EXPECT_EQ(times(load(timed("2024-12-31T22:00Z", 3, time_key(2, "2025-01-01T04:00:00.5Z")))),
            (Ids{"2024-12-31T22:00:00Z", "2025-01-01T01:00:00.25Z", "2025-01-01T04:00:00.5Z"}));
  EXPECT_EQ(times(load(timed("2024-03-01T12:00:00Z", 3, time_key(2, "2024-02-28T12:00:00Z")))),
            (Ids{"2024-03-01T12:00:00Z", "2024-02-29T12:00:00Z", "2024-02-28T12:00:00Z"}))
      << "back in time";
  EXPECT_EQ(times(load(timed("2024-06-21T06:00:00Z", 2, time_key(0, "1900-01-01T00:00:00Z")))),
            Ids(2, "1900-01-01T00:00:00Z"))
      << "a key for frame 0 takes the scene's place";
}

TEST_F(FramesTest, AFrameHasTheSunOfAStillOfItsTime) {
  const std::string place = R"(, "latitude": 36.5, "longitude": -84, "refraction": true)";
  const std::vector<Scene> path =
      load(timed("2024-06-21T10:20:00Z", 3, time_key(2, "2024-06-22T00:20:00Z"), place)).tests;
  ASSERT_EQ(path.size(), 3U);
  const Scene still = load(scene("\"sun\": {\"time\": \"2024-06-21T17:20:00Z\"" + place + "}")).tests.at(0);
  EXPECT_EQ(path[1].sun.azimuth, still.sun.azimuth);
  EXPECT_EQ(path[1].sun.elevation, still.sun.elevation);
  EXPECT_EQ(path[1].notes, still.notes);
  EXPECT_EQ(path[1].canonical_json, still.canonical_json);
  EXPECT_GT(path[1].sun.elevation, path[0].sun.elevation + 40);
}

TEST_F(FramesTest, OverridesChangeTimesOrHoldThemStill) {
  const std::string text = timed("2024-06-21T06:00:00Z", 3, time_key(2, "2024-06-21T18:00:00Z"));
  EXPECT_EQ(times(load(text, {"frames.keys.0.sun.time=2024-06-21T08:00:00Z"})).at(1), "2024-06-21T07:00:00Z");
  EXPECT_EQ(times(load(text, {"sun.time=2024-06-21T08:00:00Z"})), Ids(3, "2024-06-21T08:00:00Z"));
  EXPECT_EQ(load(text, {"sun.latitude=20"}).tests.at(1).sun.time->place->latitude, 20);
  EXPECT_EQ(elevations(load(text, {"sun.elevation=7"})), (std::vector<double>{7, 7, 7}));
  EXPECT_EQ(errors(text, {"frames.keys.0.sun.time=noon"}),
            "--set frames.keys.0.sun.time: error: /frames/keys/0/sun/time: expected a time in UTC such as "
            "2024-06-21T12:00:00Z, got \"noon\": it has to begin with a date, YYYY-MM-DD");
}

TEST_F(FramesTest, MistakesInTimesAreSaidAtTheKey) {
  const std::string expected =
      " error: /frames/keys/0/sun/time: expected a time in UTC such as 2024-06-21T12:00:00Z, got ";
  const auto mistake = [&](const std::string& time) {
    return errors(timed("2024-06-21T06:00:00Z", 3, time_key(2, time)));
  };
  EXPECT_EQ(mistake("2023-02-29T12:00:00Z"),
            "s.json:4:62:" + expected + "\"2023-02-29T12:00:00Z\": February 2023 has the days 01 to 28");
  EXPECT_EQ(mistake("2101-01-01T00:00:00Z"),
            "s.json:4:62:" + expected +
                "\"2101-01-01T00:00:00Z\": the sun's position is known for the years 1900 to 2100");
  EXPECT_EQ(
      mistake("2024-06-21T12:00:00"),
      "s.json:4:62:" + expected +
          "\"2024-06-21T12:00:00\": the Z at the end is missing, which says that it is UTC and no local "
          "time");
  EXPECT_EQ(
      errors(timed("2024-06-21T06:00:00Z", 3, R"({"frame": 2, "sun": {"time": 6}})")),
      "s.json:4:62: error: /frames/keys/0/sun/time: expected a string that is not empty (UTC), got 6. As "
      "sun.time; from key to key evenly in time. Place and refraction stay those of the scene.");
  EXPECT_EQ(errors(timed("yesterday", 3, time_key(2, "2024-06-21T06:00:00Z"))),
            "s.json:3:17: error: /sun/time: expected a time in UTC such as 2024-06-21T12:00:00Z, got "
            "\"yesterday\": it has to begin with a date, YYYY-MM-DD")
      << "the scene's own mistake is said once";
  EXPECT_EQ(errors(timed("2024-06-21T06:00:00Z", 3, time_key(2, "2024-06-21T08:00:00Z"), "")),
            "s.json:3:8: error: /sun: the place is missing: give \"latitude\" and \"longitude\" beside "
            "\"time\", in degrees; the terrain does not say where on the earth it lies")
      << "once, not for each key";
  const std::string angles =
      scene(R"("frames": {"count": 2, "keys": [{"frame": 1, "sun": {"azimuth": 6}}]})");
  EXPECT_EQ(
      errors(angles, {"sun.time=2024-06-21T06:00:00Z"}),
      "--set sun.time: error: /sun/time: the place is missing: give \"latitude\" and \"longitude\" beside "
      "\"time\", in degrees; the terrain does not say where on the earth it lies");
  EXPECT_EQ(errors(timed("2024-06-21T06:00:00Z", 2, R"({"frame": 1, "sun": {"latitude": 6}})")),
            "s.json:4:54: error: /frames/keys/0/sun/latitude: unknown key \"latitude\"; expected one of "
            "\"azimuth\", \"elevation\", \"direction\", \"time\"");
}

TEST_F(FramesTest, KeysGiveTheSunAsTheSceneDoes) {
  const std::string path =
      "\"frames\": {\"count\": 2, \"keys\": [" + time_key(1, "2024-06-21T06:00:00Z") + "]}";
  const std::string start =
      "error: /frames/keys/0/sun/time: \"time\" moves a sun that is given by \"time\", and the scene ";
  EXPECT_EQ(
      errors(scene("\"sun\": {\"elevation\": 5},\n" + path)),
      "s.json:4:62: " + start + "gives its sun by \"azimuth\" and \"elevation\": give both in the same way");
  EXPECT_EQ(errors(scene(path)),
            "s.json:3:62: " + start + "says nothing of its sun: write \"sun\": {\"time\": ...} for frame 0");
  EXPECT_EQ(
      errors(timed("2024-06-21T06:00:00Z", 4,
                   R"({"frame": 1, "sun": {"azimuth": 5}}, {"frame": 3, "sun": {"azimuth": 7}})")),
      "s.json:4:65: error: /frames/keys/0/sun/azimuth: \"azimuth\" moves a sun that is given by "
      "\"azimuth\" and \"elevation\", and the scene gives its sun by \"time\": give both in the same way\n"
      "s.json:4:102: error: /frames/keys/1/sun/azimuth: \"azimuth\" moves a sun that is given by "
      "\"azimuth\" and \"elevation\", and the scene gives its sun by \"time\": give both in the same way");
  EXPECT_EQ(
      errors(scene("\"matrix\": {\"sun.time\": [\"2024-06-21T06:00:00Z\"]},\n"
                   "\"sun\": {\"time\": \"2024-06-21T07:00:00Z\", \"latitude\": 0, \"longitude\": 0},\n"
                   "\"frames\": {\"count\": 2, \"keys\": [" +
                   time_key(0, "2024-06-21T08:00:00Z") + "]}")),
      "s.json:3:12: error: /matrix/sun.time: the key for frame 0 sets \"sun.time\" too; keep one of the "
      "two");
}

std::string directed(const std::string& from, int frame, const std::string& to) {
  return FramesTest::scene(
      "\"sun\": {\"direction\": " + from + "},\n\"frames\": {\"count\": " + std::to_string(frame + 1) +
      ", \"keys\": [{\"frame\": " + std::to_string(frame) + ", \"sun\": {\"direction\": " + to + "}}]}");
}

TEST_F(FramesTest, ADirectionTakesTheGreatCircleAtConstantSpeed) {
  // From the east over the zenith to 30 degrees above the west: 150 degrees in five steps. Lengths do not
  // count.
  const LoadResult over = load(directed("[2, 0, 0]", 5, "[-1.7320508075688772e200, 0, 1e200]"));
  ASSERT_EQ(listing(over), "");
  const std::vector<double> heights = elevations(over), compass = azimuths(over);
  for (int i = 0; i <= 5; ++i) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_NEAR(heights[at], i <= 3 ? 30 * i : 180 - 30 * i, 1e-9) << i;
    if (i != 3) {
      EXPECT_NEAR(compass[at], i < 3 ? 90 : 270, 1e-9) << i;
    }
  }
  // Between two suns of one elevation the great circle climbs: tan(middle) = tan(elevation) / cos(half the
  // turn).
  const LoadResult climb = load(directed("[1, 0, 1]", 2, "[0, 1, 1]"));
  EXPECT_NEAR(elevations(climb).at(1), 54.735610317245346, 1e-9);
  EXPECT_NEAR(azimuths(climb).at(1), 45, 1e-9);
  EXPECT_EQ(azimuths(load(directed("[0, 3, 4]", 2, "[0, 6, 8]"))), std::vector<double>(3, 0));
}

TEST_F(FramesTest, DirectionsThatTellNoWayAreErrors) {
  EXPECT_EQ(errors(directed("[1, 0, 1]", 2, "[-2, 0, -2]")),
            "s.json:4:67: error: /frames/keys/0/sun/direction: this direction is opposite to the one before "
            "it, and no way between them is the shortest; tell the way with a key between");
  EXPECT_EQ(errors(directed("[1, 0, 1]", 1, "[-2, 0, -2]")), "") << "nothing lies between";
  EXPECT_EQ(
      errors(directed("[1, 0, 1]", 2, "[0, 0, 0]")),
      "s.json:4:67: error: /frames/keys/0/sun/direction: the direction has no length; expected a vector "
      "towards the sun");
  EXPECT_EQ(errors(directed("[0, 0, 0]", 2, "[1, 0, 1]")),
            "s.json:3:22: error: /sun/direction: the direction has no length; expected a vector towards the "
            "sun");
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
