// SPDX-License-Identifier: MIT
// The program as a user meets it: exit codes, messages, goldens that bite, nothing half-written.
#include <gtest/gtest.h>

#include <numeric>

#include "image/image.h"
#include "testing/program_fixture.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

using testing::Gnomon;
using testing::Ran;

TEST_F(Gnomon, WrongUsageIsTwo) {
  EXPECT_EQ(run("").code, 2);
  EXPECT_EQ(run("nonsense").code, 2);
  EXPECT_EQ(run("render -o x.png").code, 2);
  EXPECT_EQ(run("render --heightmap a.png --sun north -o x.png").code, 2);
  EXPECT_EQ(run("test --shard 3/2").code, 2);
  EXPECT_EQ(run("--help").code, 0);
  EXPECT_EQ(run("test --help").code, 0);
}

TEST_F(Gnomon, UnreadableHeightMapsAreTwoAndLeaveTheOutputAlone) {
  write("text.png", "these are no heights");
  write("o.exr", "older");
  for (const char* name : {"missing.png", "text.png", "."}) {
    const Ran ran = run(std::string("render --heightmap ") + name + " -o o.exr");
    EXPECT_EQ(ran.code, 2) << ran.output;
    EXPECT_SAYS(ran, "error: ");
    EXPECT_EQ(read("o.exr"), "older");
  }
}

TEST_F(Gnomon, RendersAHeightMapAtATimeAndSaysWhereTheSunStands) {
  const std::string map = "--heightmap " + quote(GNOMON_SOURCE_DIR "/testcases/terrain/jacksboro.png");
  const Ran ran = run("render " + map + " --time 2024-06-21T12:00Z --at 36.4,-84.2 -o time.exr");
  EXPECT_EQ(ran.code, 0) << ran.output;
  EXPECT_SAYS(ran,
              "sun on 2024-06-21T12:00:00Z at latitude 36.4, longitude -84.2: elevation 17.72525 degrees");
  EXPECT_SAYS(ran, "azimuth 73.55456 from true north");
  ASSERT_EQ(run("render " + map + " --sun 73.55456,17.72525 -o angles.exr").code, 0);
  EXPECT_EQ(run("diff time.exr angles.exr --channel b_shadow --max-mismatch 0.0005").code, 0);
  ASSERT_EQ(run("render " + map + " -o default.exr").code, 0);
  EXPECT_EQ(run("diff time.exr default.exr --channel b_shadow --max-mismatch 0.0005").code, 1);
}

TEST_F(Gnomon, ATimeNeedsAPlaceAndNoOtherSun) {
  EXPECT_SAYS(run("render --heightmap missing.tif --time 2024-06-21T12:00:00Z -o o.exr"),
              "there is no such file");
  const std::string map =
      "render --heightmap " + quote(GNOMON_SOURCE_DIR "/testcases/terrain/jacksboro.png") + " -o o.exr ";
  for (const auto& [options, says] :
       {std::pair{"--time 2024-06-21T12:00:00Z",
                  "--time: error: the height map does not say where on the "
                  "earth it lies: add --at LAT,LON"},
        {"--time 2024-06-21T12:00:00 --at 1,2", "--time: expected a time in UTC"},
        {"--time 2024-02-30T12:00:00Z --at 1,2", "February 2024 has the days 01 to 29"},
        {"--time 2024-06-21T12:00:00Z --at 91,2", "--at: error: a latitude lies between -90 and 90"},
        {"--time 2024-06-21T12:00:00Z --at 1,200", "a longitude between -180 and 180"},
        {"--time 2024-06-21T12:00:00Z --at 1", "'1' is not LAT,LON"},
        {"--at 1,2", "--at: says where the map lies at a --time"},
        {"--sun 1,2 --time 2024-06-21T12:00:00Z --at 1,2", "leave one out"}}) {
    const Ran ran = run(map + options);
    EXPECT_EQ(ran.code, 2) << options;
    EXPECT_SAYS(ran, says);
  }
  write_scene("a", R"([{"reference": {}}])");
  EXPECT_EQ(run("render testcases/a.json -o o.exr --time 2024-06-21T12:00:00Z --at 1,2").code, 2);
  EXPECT_FALSE(fs::exists(root_ / "o.exr"));
  const Ran set =
      run("render testcases/a.json -o o.exr --set sun.time=2024-06-21T12:00:00Z "
          "--set sun.latitude=36.4 --set sun.longitude=-84.2");
  EXPECT_EQ(set.code, 0) << set.output;
  EXPECT_SAYS(set, "elevation 17.72525 degrees");
}

TEST_F(Gnomon, UnwritableOutputIsNinetyNine) {
  write_scene("a", R"([{"reference": {}}])");
  EXPECT_EQ(run("render testcases/a.json -o missing/o.exr").code, 99);
}

TEST_F(Gnomon, InvalidSceneIsLocatedAndTheOthersRun) {
  write_scene("good", R"([{"reference": {}}])");
  write("testcases/bad.json", "{\n  \"version\": 1,\n  \"descripton\": \"d\"\n}\n");
  const Ran ran = run("test");
  EXPECT_EQ(ran.code, 2);
  EXPECT_SAYS(ran, "testcases/bad.json:3:3");
  EXPECT_SAYS(ran, "1 passed, 1 failed");
}

TEST_F(Gnomon, FilterThatMatchesNothingIsTwoAndAnEmptyShardIsFine) {
  write_scene("a", R"([{"reference": {}}])");
  EXPECT_EQ(run("test --filter 'b*'").code, 2);
  const Ran ran = run("test --shard 2/2");
  EXPECT_EQ(ran.code, 0);
  EXPECT_SAYS(ran, "0 passed, 0 failed");
}

TEST_F(Gnomon, NewSceneValidatesAndPasses) {
  EXPECT_EQ(run("new area/case").code, 0);
  EXPECT_EQ(run("validate testcases/area/case.json").code, 0);
  const Ran ran = run("test");
  EXPECT_EQ(ran.code, 0) << ran.output;
  EXPECT_EQ(run("new area/case").code, 2) << "an existing scene is not overwritten";
}

TEST_F(Gnomon, MissingGoldenFailsAndPrintsTheAcceptCommand) {
  write_scene("a", R"([{"golden": {}}])");
  const Ran ran = run("test");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "--update-goldens");
  EXPECT_EQ(run("test --update-goldens missing").code, 0);
  EXPECT_EQ(run("test").code, 0);
}

TEST_F(Gnomon, CamerasAndFramesMakeImagesAndAPreviewEach) {
  write("testcases/a.json",
        R"({"version": 1, "description": "d", "terrain": {"procedural": "cone", "size": [32, 32]},
            "cameras": {"map": {"map": {}}, "side": {"orthographic": {"eye": [40, -40, 40], "target": [16, 16, 0],
                        "height": 40, "size": [24, 16]}}},
            "frames": {"count": 3, "keys": [{"frame": 2, "sun": {"azimuth": 100}, "cameras": {"side": {"height": 20}}}]},
            "expect": [{"reference": {}}]})");
  const Ran rendered = run("render testcases/a.json -o o.exr");
  EXPECT_EQ(rendered.code, 0);
  EXPECT_EQ(rendered.output,
            "o@camera=map,frame=0000.exr\no@camera=map,frame=0001.exr\no@camera=map,frame=0002.exr\no@camera="
            "map.gif\n"
            "o@camera=side,frame=0000.exr\no@camera=side,frame=0001.exr\no@camera=side,frame=0002.exr\n"
            "o@camera=side.gif\n");
  EXPECT_EQ(read("o@camera=map.gif").substr(0, 6), "GIF89a");
  EXPECT_NE(read("o@camera=map,frame=0000.exr"), read("o@camera=map,frame=0001.exr"));
  const Ran one = run("render testcases/a.json --set 'camera={\"map\": {}}' -o p.png");
  EXPECT_EQ(one.output, "p@frame=0000.png\np@frame=0001.png\np@frame=0002.png\np.gif\n");
  const Ran some = run("test --filter '*map,frame=0001' --list");
  EXPECT_EQ(some.output, "a@camera=map,frame=0001\n");
  EXPECT_SAYS(run("test --filter '*camera=side*'"), "3 passed, 0 failed");
  EXPECT_SAYS(run("test --set frames.keys.0.frame=9"),
              "--set frames.keys.0.frame: error: /frames/keys/0/frame: there is no");
}

/// A plain of 16 m from above, a pixel a metre: 16 pixels see its western border and 16 the eastern one, the
/// centres `aside` pixels east of it.
std::string border_scene(const std::string& aside) {
  return R"({"version": 1, "description": "d", "terrain": {"procedural": "flat", "size": [16, 16]}, "camera": {
    "orthographic": {"eye": [8.5)" +
         aside + R"(, 8.25, 9], "target": [8.5)" + aside +
         R"(, 8.25, 0], "height": 20, "size": [20, 20]}}, "expect": [{"golden": {}}]})";
}

TEST_F(Gnomon, TheBandOfAGoldenHoldsWhatChangesWithinASixtyFourthOfAPixel) {
  write("testcases/near.json", border_scene("1"));
  write("testcases/far.json", border_scene("2"));
  ASSERT_EQ(run("test --update-goldens missing").code, 0);
  const auto marked = [&](const char* name) {
    const image::Image golden = image::read_image((root_ / "goldens" / name).string()).value();
    const std::vector<float>& band = golden.channels.at("band");
    return std::accumulate(band.begin(), band.end(), 0.0);
  };
  EXPECT_EQ(marked("near.exr"), 32) << "0.01 pixel aside: 1/64 crosses the border";
  EXPECT_EQ(marked("far.exr"), 0) << "0.02 pixel aside";
}

TEST_F(Gnomon, NinePixelsOfAGoldenAreSeen) {
  write_scene("a", R"([{"golden": {}}])");
  write_scene("b", R"([{"golden": {}}])", 80);
  ASSERT_EQ(run("test --update-goldens missing").code, 0);
  const std::string path = (root_ / "goldens/b.exr").string();
  image::Image golden = image::read_image(path).value();
  for (std::size_t i = 0; i < 9; ++i)
    golden.channels["b_shadow"][1000 + 37 * i] = 1 - golden.channels["b_shadow"][1000 + 37 * i];
  ASSERT_TRUE(image::write_exr(path, golden).ok());
  const Ran ran = run("test");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "9 of");
  EXPECT_SAYS(ran, "testcases/b.json");
  EXPECT_SAYS(ran, "1 passed, 1 failed");
}

TEST_F(Gnomon, DamagedTraversalIsSeenWithoutARebuild) {
  install();
  write_scene("a", R"([{"golden": {}}])");
  ASSERT_EQ(run("test --update-goldens missing").code, 0);
  // Erratum b: the block's maximum compared where the ray leaves it.
  replace("share/gnomon/relief/multilevel.glsl", "ray.height + ray.rise * cursor.t)",
          "ray.height + ray.rise * min(gnomon_ray_exits(ray, block << level, level).x, gnomon_ray_exits(ray, "
          "block << "
          "level, level).y))");
  const Ran ran = run("test");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "0 passed, 1 failed");
}

TEST_F(Gnomon, ErrorThreeIncludesDeepIsReportedWhereItIs) {
  install();
  write_scene("a", R"([{"reference": {}}])");
  replace("share/gnomon/core/ray.glsl", "ray.rise = to_sun.z / fastest;", "ray.rise = to_sun.z / fastets;");
  const Ran ran = run("render testcases/a.json -o o.exr");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "core/ray.glsl:");
  EXPECT_SAYS(ran, "'fastets'");
  EXPECT_SAYS(ran, "included from");
  EXPECT_FALSE(fs::exists(root_ / "o.exr"));
}

TEST_F(Gnomon, RayThatReachesTheStepBoundIsAnErrorNotALitPixel) {
  install();
  write_scene("a", R"([{"reference": {}}])");
  replace("share/gnomon/programs/multilevel.frag", "u_step_limit", "3");
  const Ran ran = run("render testcases/a.json -o o.exr");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "undecided");
}

TEST_F(Gnomon, HangingTestFailsAloneAndTheOthersGoOn) {
  write_scene("quick", R"([{"reference": {}}])", 16);
  write_scene("slow", R"([{"reference": {}}])", 16384);
  const Ran ran = run("test --timeout 8 --jobs 1");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "no answer within 8 s");
  EXPECT_SAYS(ran, "1 passed, 1 failed");
}

TEST_F(Gnomon, SceneWhoseExpectIsNoListCostsItselfOnly) {
  write_scene("good", R"([{"reference": {}}])");
  write_scene("bad", "1");
  const Ran ran = run("test");
  EXPECT_EQ(ran.code, 2);
  EXPECT_SAYS(ran, "/expect");
  EXPECT_SAYS(ran, "1 passed, 1 failed");
  EXPECT_EQ(run("test --filter good").code, 0) << "a scene that no filter can mean does not count";
}

TEST_F(Gnomon, NothingIsRenderedOverItsOwnInput) {
  write_scene("a", R"([{"reference": {}}])");
  ASSERT_EQ(run("render testcases/a.json --set shadow.method=reference -o a.exr").code, 0);
  const std::string before = read("a.exr");
  EXPECT_EQ(run("render --heightmap a.exr --channel horizon -o a.exr").code, 2);
  EXPECT_EQ(read("a.exr"), before);
}

TEST_F(Gnomon, NumbersThatAreNoneAreTwo) {
  write_scene("a", R"([{"reference": {}}])");
  ASSERT_EQ(run("render testcases/a.json --set shadow.method=reference -o a.exr").code, 0);
  const std::string heights = "render --heightmap a.exr --channel horizon -o o.exr ";
  for (const char* option :
       {"--receiver-height nan", "--vertical-scale inf", "--spacing 1e300", "--sun nan,3"}) {
    EXPECT_EQ(run(heights + option).code, 2) << option;
  }
  EXPECT_EQ(run("test --timeout nan").code, 2);
  EXPECT_EQ(run("bench --elevation nan").code, 2);
  EXPECT_EQ(run(heights).code, 0);
}

TEST_F(Gnomon, BrokenGoldenCanBeReplaced) {
  write_scene("a", R"([{"golden": {}}])");
  write("goldens/a.exr", "no image");
  EXPECT_EQ(run("test").code, 2);
  EXPECT_EQ(run("test --update-goldens missing").code, 2);
  EXPECT_EQ(run("test --update-goldens changed").code, 0);
  EXPECT_EQ(run("test").code, 0);
}

TEST_F(Gnomon, DiffOfEqualImagesIsZeroAndOfOtherSizesOne) {
  write_scene("a", R"([{"reference": {}}])");
  write_scene("b", R"([{"reference": {}}])", 80);
  ASSERT_EQ(run("render testcases/a.json -o a.exr").code, 0);
  ASSERT_EQ(run("render testcases/b.json -o b.exr").code, 0);
  EXPECT_EQ(run("diff a.exr a.exr").code, 0);
  EXPECT_EQ(run("diff a.exr b.exr -o d.png").code, 1);
  EXPECT_EQ(run("diff a.exr missing.exr").code, 2);
  EXPECT_EQ(run("diff a.exr a.exr --tolerance nonsense").code, 2);
}

TEST_F(Gnomon, DiffOfNamedChannelsLooksAtNoOther) {
  write_scene("a", R"([{"reference": {}}])");
  ASSERT_EQ(run("render testcases/a.json -o a.exr").code, 0);
  ASSERT_EQ(run("render testcases/a.json --set shadow.k_dark=0.5 -o k.exr").code, 0);
  ASSERT_EQ(run("render testcases/a.json --set shadow.method=reference -o r.exr").code, 0);
  EXPECT_EQ(run("diff a.exr k.exr").code, 1);
  EXPECT_EQ(run("diff a.exr k.exr --channel b_shadow --channel steps").code, 0);
  EXPECT_EQ(run("diff a.exr k.exr --channel b_shadow --channel k_shadow").code, 1);
  EXPECT_EQ(run("diff a.exr r.exr").code, 1);  // an engine's image has no horizon
  EXPECT_EQ(run("diff a.exr r.exr --channel b_shadow").code, 0);
  EXPECT_EQ(run("diff a.exr r.exr --channel shadow").code, 2);
}

TEST_F(Gnomon, AnInterruptStopsItUnlessWhoStartedItIgnoresThem) {
  std::string job = quote(program_) + " bench --rounds 1";
  for (int size = 60; size < 65; ++size) job += " --size " + std::to_string(size);
  const auto end_of = [&](const std::string& before, const std::string& signal) {
    // It is interrupted once its first table is there, and has four more to come.
    return testing::run_command("cd " + quote(root_.string()) + " && bash -c " +
                                quote(before + "rm -f table; " + job +
                                      " > table & until [ -s table ]; do sleep 0.1; done; kill -" + signal +
                                      " $!; wait $!"));
  };
  EXPECT_EQ(end_of("", "HUP").code, 130);
  EXPECT_EQ(end_of("trap '' HUP; ", "HUP").code, 0) << "nohup";
}

TEST_F(Gnomon, AFileSizeLimitIsTheMachinesFailureAndLeavesNothing) {
  write_scene("map", R"([{"reference": {}}])");
  const Ran ran = testing::run_command("cd " + quote(root_.string()) + " && ulimit -f 1 && " +
                                       quote(program_) + " render testcases/map.json -o big.exr");
  EXPECT_EQ(ran.code, 99) << ran.output;
  EXPECT_FALSE(fs::exists(root_ / "big.exr"));
}

}  // namespace
}  // namespace gnomon
