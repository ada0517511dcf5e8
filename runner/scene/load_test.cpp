// SPDX-License-Identifier: MIT
#include "scene/load.h"

#include <cstdint>

#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

using Load = ScratchProject;
using Mistakes = ScratchProject;

TEST_F(Load, TheSmallestSceneTakesTheDefaults) {
  const LoadResult result = load(scene());
  ASSERT_EQ(listing(result), "");
  const Scene& test = result.tests.at(0);
  EXPECT_EQ(test.id, "s");
  EXPECT_EQ(test.golden_file, (root / "goldens/s.exr").generic_string());
  EXPECT_EQ(test.sun.azimuth, 315);
  EXPECT_EQ(test.sun.elevation, 45);
  EXPECT_EQ(test.shadow.method, "multilevel");
  EXPECT_FALSE(std::get<MapCamera>(test.camera).size);
  EXPECT_FALSE(test.terrain.spacing);
}

TEST_F(Load, ReadsEveryKey) {
  const LoadResult result = load(scene(
      R"("$schema": "x", "sun": {"azimuth": -90, "elevation": -1.5}, "camera": {"map": {"size": [30, 20]}},
         "shadow": {"method": "brute_force", "q": 2, "k_dark": 0.1, "k_bright": 1, "receiver_height": 50})",
      R"({"heights": [[1, 2, 3, 4], [5, 6, 7.5, 8]], "spacing": [2, 3], "vertical_scale": 10})",
      R"([{"golden": {"max_mismatch": 0.5, "tolerance": {"k_shadow": 0.1}, "band": false, "unproven": "why"}},
          {"reference": {"mismatch": [0.1, 0.2], "level": 1}}, {"probe": {"at": [29, 19], "b_shadow": 1}},
          {"max_steps": 7}])"));
  ASSERT_EQ(listing(result), "");
  const Scene& test = result.tests.at(0);
  const auto& heights = std::get<InlineTerrain>(test.terrain.source);
  EXPECT_EQ(heights.width, 4);
  EXPECT_EQ(heights.height, 2);
  EXPECT_EQ(heights.heights[6], 7.5);
  EXPECT_EQ(test.terrain.spacing, (std::array{2.0, 3.0}));
  EXPECT_EQ(test.terrain.vertical_scale, 10);
  EXPECT_EQ(test.sun.azimuth, 270);
  EXPECT_EQ(std::get<MapCamera>(test.camera).size, (std::array{30, 20}));
  EXPECT_EQ(test.shadow.receiver_height, 50);
  const auto& golden = std::get<GoldenExpectation>(test.expect.at(0));
  EXPECT_EQ(golden.tolerance.at("k_shadow"), 0.1);
  EXPECT_FALSE(golden.band);
  EXPECT_EQ(golden.unproven, "why");
  EXPECT_EQ(std::get<ReferenceExpectation>(test.expect.at(1)).mismatch, (std::array{0.1, 0.2}));
  EXPECT_EQ(std::get<ReferenceExpectation>(test.expect.at(1)).level, 1);
  EXPECT_EQ(std::get<ProbeExpectation>(test.expect.at(2)).x, 29);
  EXPECT_EQ(std::get<MaxStepsExpectation>(test.expect.at(3)).limit, 7);
}

TEST_F(Load, AzimuthsTurnIntoOneCircle) {
  for (const auto& [given, taken] : {std::pair{"-90", 270.0}, {"360", 0.0}, {"-1e-300", 0.0}, {"725", 5.0}}) {
    EXPECT_EQ(load(scene(std::string("\"sun\": {\"azimuth\": ") + given + "}")).tests.at(0).sun.azimuth,
              taken);
  }
}

TEST_F(Load, DirectionsBecomeAnglesExactlyOnTheAxes) {
  for (const auto& [given, azimuth, elevation] : {std::tuple{"[1, 0, 0]", 90.0, 0.0},
                                                  {"[-5, 0, 0]", 270.0, 0.0},
                                                  {"[0, -1, 1]", 180.0, 45.0},
                                                  {"[0, 1e308, 1e308]", 0.0, 45.0},
                                                  {"[0, 0, 1e-300]", 0.0, 90.0},
                                                  {"[0, 0, -1]", 0.0, -90.0}}) {
    const Sun sun = load(scene(std::string("\"sun\": {\"direction\": ") + given + "}")).tests.at(0).sun;
    EXPECT_EQ(sun.azimuth, azimuth) << given;
    EXPECT_EQ(sun.elevation, elevation) << given;
  }
}

TEST_F(Load, CanonicalJsonChangesOnlyWithTheImage) {
  const auto canonical = [&](const std::string& text) { return load(text).tests.at(0).canonical_json; };
  const std::string plain = canonical(scene());
  EXPECT_EQ(canonical(scene(
                R"("shadow": {"q": 0, "k_bright": 0.6}, "sun": {"azimuth": -45}, "camera": {"map": {}})",
                R"({"spacing": 1.0, "size": [256, 256], "procedural": "cone"})", R"([{"max_steps": 5}])")),
            plain);
  for (const char* change :
       {R"("sun": {"azimuth": 1})", R"("sun": {"elevation": 1})", R"("shadow": {"q": 1})",
        R"("camera": {"map": {"size": [256, 256]}})", R"("shadow": {"receiver_height": 1})"}) {
    EXPECT_NE(canonical(scene(change)), plain) << change;
  }
  EXPECT_NE(canonical(scene("", R"({"procedural": "cone", "parameters": {"height": 2}})")), plain);
}

TEST_F(Load, TheSizeOfAFileIsCheckedOnceItIsKnown) {
  write("testcases/m.png", "x");
  const std::string text = scene("\"shadow\": {\"q\": 5}", R"({"file": "m.png"})",
                                 R"([{"probe": {"at": [16, 3], "b_shadow": 1}}])");
  const LoadResult unknown = load(text);
  ASSERT_EQ(unknown.tests.size(), 1U);
  EXPECT_TRUE(check_size(unknown.tests[0], 17, 4).empty());
  const Diagnostics late = check_size(unknown.tests[0], 16, 4);
  ASSERT_EQ(late.size(), 2U);
  EXPECT_EQ(late[0].message, "/shadow/q: level 5 does not exist; the coarsest level of a 16x4 map is L = 4");
  vocabulary.file_size = [](const FileTerrain&) { return std::array{16, 4}; };
  EXPECT_EQ(
      errors(text),
      "s.json:1:64: error: /expect/0/probe/at: the pixel [16, 3] lies outside the 16x4 image (counted from "
      "0)\n"
      "s.json:3:17: error: /shadow/q: level 5 does not exist; the coarsest level of a 16x4 map is L = 4");
}

TEST_F(Mistakes, InTheTerrain) {
  const auto terrain = [&](const std::string& text) { return errors(scene("", text)); };
  EXPECT_EQ(terrain(R"({"procedural": "con"})"),
            "s.json:2:27: error: /terrain/procedural: unknown kind of procedural map \"con\"; did you mean "
            "\"cone\"?");
  EXPECT_EQ(
      terrain(R"({"procedural": "sphere"})"),
      "s.json:2:27: error: /terrain/procedural: unknown kind of procedural map \"sphere\"; expected one of "
      "\"cone\", \"fractal\"");
  EXPECT_EQ(
      terrain(R"({"procedural": "cone", "parameters": {"hieght": 1}})"),
      "s.json:2:50: error: /terrain/parameters/hieght: unknown parameter of cone \"hieght\"; did you mean "
      "\"height\"?");
  EXPECT_EQ(terrain(R"({"procedural": "cone", "size": [0, 16385]})"),
            "s.json:2:44: error: /terrain/size/0: expected an integer from 1 to 16384, got 0\n"
            "s.json:2:47: error: /terrain/size/1: expected an integer from 1 to 16384, got 16385");
  EXPECT_EQ(
      terrain(R"({"procedural": "cone", "size": [256]})"),
      "s.json:2:43: error: /terrain/size: expected a list of exactly 2, each an integer from 1 to 16384 "
      "(samples), got [256]. Samples from west to east and from north to south.");
  EXPECT_EQ(
      terrain(R"({"procedural": "cone", "spacing": 0})"),
      "s.json:2:46: error: /terrain/spacing: expected a number above 0 (m), got 0. Distance between samples: "
      "one number, or [west to east, north to south]. A file with a georeference needs none.");
  EXPECT_EQ(
      terrain(R"({"procedural": "cone", "spacing": "1"})"),
      "s.json:2:46: error: /terrain/spacing: expected a number above 0, or a list of exactly 2, each a "
      "number "
      "above 0 (m), got \"1\". Distance between samples: one number, or [west to east, north to south]. A "
      "file with a georeference needs none.");
  EXPECT_EQ(terrain(R"({"procedural": "cone", "seed": 4294967296})"),
            "s.json:2:43: error: /terrain/seed: expected an integer from 0 to 4294967295, got 4294967296. "
            "Seed of the "
            "kinds that are random.");
  EXPECT_EQ(
      terrain(R"({"procedural": "cone", "file": "x.png"})"),
      "s.json:2:35: error: /terrain/file: \"file\" does not go together with \"procedural\": give one or the "
      "other");
  EXPECT_EQ(
      terrain(R"({"procedrual": "cone"})"),
      "s.json:2:13: error: /terrain/procedrual: unknown key \"procedrual\"; did you mean \"procedural\"?");
  EXPECT_EQ(terrain(R"({"spacing": 1})"),
            "s.json:2:12: error: /terrain: expected an object with \"procedural\", or an object with "
            "\"file\", or an "
            "object with \"heights\", got {\"spacing\":1}. The height map: procedural, from a file, or "
            "written out as "
            "heights.");
}

TEST_F(Mistakes, InWrittenHeights) {
  const auto heights = [&](const std::string& rows) {
    return errors(scene("", "{\"heights\": " + rows + "}"));
  };
  EXPECT_EQ(heights("[[1, 2], [3], [4, 5]]"),
            "s.json:2:33: error: /terrain/heights/1: this row has 1 heights, the first one 2; expected rows "
            "of equal "
            "length");
  EXPECT_EQ(heights("[]"),
            "s.json:2:24: error: /terrain/heights: expected a list of 1 to 16384, each a list of 1 to 16384, "
            "each a "
            "number or null (stored units), got []. Heights written out: rows of equal length, the north row "
            "first.");
  EXPECT_EQ(
      heights("[[1], []]"),
      "s.json:2:30: error: /terrain/heights/1: expected a list of 1 to 16384, each a number or null, got []. "
      "One row from west to east; null where there is no data.");
  EXPECT_EQ(heights("[[1, null]]"), "");
  EXPECT_EQ(heights("[[1, true]]"),
            "s.json:2:29: error: /terrain/heights/0/1: expected a number or null, got true");
  EXPECT_EQ(
      heights("[[1, 1e39]]"),
      "s.json:2:29: error: /terrain/heights/0/1: the height is too large for single precision; expected "
      "at most "
      "1e15 m");
  EXPECT_EQ(heights("[[1, 1e999]]"),
            "s.json:2:29: error: invalid JSON: this number is too large for a double (above 1.8e308)");
}

TEST_F(Mistakes, InSunCameraAndShadow) {
  const auto member = [&](const std::string& text) { return errors(scene(text)); };
  EXPECT_EQ(member(R"("sun": {"elevation": 90.5})"),
            "s.json:3:22: error: /sun/elevation: expected a number from -90 to 90 (degrees), got 90.5. "
            "Height of the "
            "sun above the horizon.");
  EXPECT_EQ(member(R"("sun": {"azimuth": "north"})"),
            "s.json:3:20: error: /sun/azimuth: expected a number (degrees), got \"north\". Compass direction "
            "in which "
            "the sun stands, clockwise from grid north; taken modulo 360.");
  EXPECT_EQ(
      member(R"("sun": {"azimuth": 1, "direction": [0, 0, 1]})"),
      "s.json:3:9: error: /sun/azimuth: \"azimuth\" does not go together with \"direction\": give one or the "
      "other");
  EXPECT_EQ(
      member(R"("sun": {"direction": [0, 0.0, 0]})"),
      "s.json:3:22: error: /sun/direction: the direction has no length; expected a vector towards the sun");
  EXPECT_EQ(member(R"("sun": {"direction": [0, 1]})"),
            "s.json:3:22: error: /sun/direction: expected a list of exactly 3, each a number, got [0,1]. "
            "Vector [x, y, "
            "z] towards the sun (east, north, up), of any length but zero.");
  EXPECT_EQ(member(R"("sun": {"date": "2024-06-21T12:00Z"})"),
            "s.json:3:9: error: /sun/date: unknown key \"date\"; expected one of \"azimuth\", \"elevation\"");
  EXPECT_EQ(
      member(R"("sun": 5)"),
      "s.json:3:8: error: /sun: expected an object that may hold \"azimuth\", \"elevation\", or an "
      "object with "
      "\"direction\", or an object with \"time\", got 5. Where the sun stands: as angles, as a direction "
      "towards it, or by time and place.");
  EXPECT_EQ(member(R"("camera": {"panorama": {}})"),
            "s.json:3:12: error: /camera/panorama: unknown key \"panorama\"; expected one of \"map\", "
            "\"perspective\", \"orthographic\", \"points\"");
  EXPECT_EQ(member(R"("camera": {"perspective": {"eye": [1, 2, 3], "target": [1, 2, 3]}})"),
            "s.json:3:56: error: /camera/perspective/target: the target is the eye itself; expected a point "
            "in the middle of the image, a micrometre or more away");
  EXPECT_EQ(
      member(R"("ground": {"albedo": {"heights": [{"height": 5, "colour": [0, 0, 0]},
{"height": 5, "colour": [1, 1, 1]}]}})"),
      "s.json:4:1: error: /ground/albedo/heights/1/height: expected heights that rise from entry to entry");
  EXPECT_EQ(member(R"("shadow": {"method": "multi_level"})"),
            "s.json:3:22: error: /shadow/method: unknown shadow method \"multi_level\"; did you mean "
            "\"multilevel\"?");
  EXPECT_EQ(
      member(R"("shadow": {"q": 1.0})"),
      "s.json:3:17: error: /shadow/q: expected an integer of at least 0, or \"auto\", got 1.0. Level of "
      "detail: 0 is the map itself, each further level halves it.");
  EXPECT_EQ(member(R"("shadow": {"q": 9223372036854775807})"),
            "s.json:3:17: error: /shadow/q: level 2147483647 does not exist; the coarsest level of a 256x256 "
            "map is "
            "L = 8");
  EXPECT_EQ(
      member(R"("shadow": {"k_dark": -0.1, "receiver_height": -1})"),
      "s.json:3:22: error: /shadow/k_dark: expected a number from 0 to 1, got -0.1. Brightness of shadowed "
      "ground that faces away from the sun.\n"
      "s.json:3:47: error: /shadow/receiver_height: expected a number of at least 0 (m), got -1. How far "
      "above "
      "the surface of the level the shadow is asked for.");
}

TEST_F(Mistakes, InExpectations) {
  const auto expect = [&](const std::string& text) {
    return errors(scene("", R"({"procedural": "cone"})", text));
  };
  EXPECT_EQ(
      expect("[]"),
      "s.json:1:46: error: /expect: expected a list of at least 1, got []. What must hold of the image; "
      "every one is checked.");
  EXPECT_EQ(expect(R"([{"golden": {}, "reference": {}}])"),
            "s.json:1:62: error: /expect/0/reference: \"reference\" does not go together with \"golden\": "
            "give one or "
            "the other");
  EXPECT_EQ(
      expect(R"([{"golden": {"tolerance": {"b_shade": 0}}}])"),
      "s.json:1:73: error: /expect/0/golden/tolerance/b_shade: unknown channel \"b_shade\"; did you mean "
      "\"b_shadow\"?");
  EXPECT_EQ(expect(R"([{"golden": {"max_mismatch": 2}}])"),
            "s.json:1:75: error: /expect/0/golden/max_mismatch: expected a number from 0 to 1, got 2. Share "
            "of valid "
            "pixels outside the band that may differ.");
  EXPECT_EQ(expect(R"([{"reference": {"mismatch": [0.2, 0.1]}}])"),
            "s.json:1:74: error: /expect/0/reference/mismatch: expected [least, greatest], got [0.2,0.1]");
  EXPECT_EQ(expect(R"([{"reference": {"level": 9}}])"),
            "s.json:1:71: error: /expect/0/reference/level: level 9 does not exist; the coarsest level of a "
            "256x256 "
            "map is L = 8");
  EXPECT_EQ(expect(R"([{"probe": {"at": [1, 2]}}])"),
            "s.json:1:57: error: /expect/0/probe: expected an object with \"at\" and at least one further "
            "key, each a "
            "number, got {\"at\":[1,2]}. One pixel's values by channel, exactly.");
  EXPECT_EQ(expect(R"([{"probe": {"b_shadow": 1}}])"),
            "s.json:1:57: error: /expect/0/probe: missing key \"at\". The pixel [x, y], counted from the "
            "north-west "
            "corner.");
  EXPECT_EQ(expect(R"([{"probe": {"at": [256, 0], "b_shadow": 1}}])"),
            "s.json:1:64: error: /expect/0/probe/at: the pixel [256, 0] lies outside the 256x256 image "
            "(counted from "
            "0)");
  EXPECT_EQ(expect(R"([{"max_step": 5}])"),
            "s.json:1:48: error: /expect/0/max_step: unknown key \"max_step\"; did you mean \"max_steps\"?");
  EXPECT_EQ(expect(R"([{"max_steps": 0}])"),
            "s.json:1:61: error: /expect/0/max_steps: expected an integer of at least 1 (steps), got 0. No "
            "ray takes "
            "more steps than this.");
}

TEST_F(Mistakes, InTheSceneAsAWhole) {
  EXPECT_EQ(errors("[]"),
            "s.json:1:1: error: expected an object with \"version\", \"description\", \"terrain\", "
            "\"expect\", got []. "
            "What a test renders and what it expects of the image.");
  EXPECT_EQ(errors("{\"version\": 2}"),
            "s.json:1:1: error: missing key \"description\". One sentence for a person: what the scene shows "
            "and why "
            "the answer is known.\n"
            "s.json:1:1: error: missing key \"terrain\". The height map: procedural, from a file, or written "
            "out as "
            "heights.\n"
            "s.json:1:1: error: missing key \"expect\". What must hold of the image; every one is checked.\n"
            "s.json:1:13: error: /version: expected 1, got 2. Version of the scene format.");
  EXPECT_EQ(errors(scene("\"foo\": 1")),
            "s.json:3:1: error: /foo: unknown key \"foo\"; expected one of \"$schema\", \"version\", "
            "\"description\", "
            "\"terrain\", \"sun\", \"camera\", \"cameras\", \"frames\", \"shadow\", \"ground\", \"matrix\", "
            "\"expect\"");
}

TEST_F(Mistakes, AreAllSaidAtOnceInTheOrderOfTheFile) {
  const std::string found = errors(
      "{\"version\": 1, \"descriptoin\": \"d\",\n"
      "\"terrain\": {\"procedural\": \"con\"},\n"
      "\"sun\": {\"elevation\": 91}, \"sun\": {},\n"
      "\"shadow\": {\"method\": \"none\"},\n"
      "\"expect\": [{\"max_steps\": 0.5}]}");
  std::vector<std::string> places;
  for (std::size_t at = 0; (at = found.find("s.json:", at)) != std::string::npos; at += 7) {
    places.push_back(found.substr(at + 7, found.find(": ", at) - at - 7));
  }
  EXPECT_EQ(places, (std::vector<std::string>{"1:1", "1:16", "2:27", "3:22", "3:27", "4:22", "5:26"}))
      << found;
}

TEST_F(Mistakes, OfAHostileFileAreLimited) {
  std::string keys;
  for (int i = 0; i < 300; ++i) keys += ",\"x" + std::to_string(i) + "\": 1";
  const LoadResult result = load(scene("\"$schema\": \"\"" + keys));
  EXPECT_EQ(result.diagnostics.size(), 101U);
  EXPECT_EQ(result.diagnostics.back().message, "further errors are left out; correct the first ones");
  for (const Diagnostic& diagnostic : load(scene("\"" + std::string(100000, 'k') + "\": 1")).diagnostics) {
    EXPECT_LT(diagnostic.message.size(), 1100U);
  }
}

/// A generator of our own: the standard distributions differ between libraries.
class Random {
 public:
  std::size_t below(std::size_t limit) {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<std::size_t>(state_ >> 33U) % limit;
  }

 private:
  std::uint64_t state_ = 20240621;
};

TEST_F(Load, NoDamagedSceneCrashes) {
  const std::string whole = scene(
      R"("sun": {"azimuth": 135, "elevation": 10}, "camera": {"map": {"size": [64, 32]}},
         "shadow": {"method": "multilevel", "q": 1}, "matrix": {"sun.elevation": [1, 10], "shadow.q": [0, 1]})",
      R"({"heights": [[0, 1.5], [2, 3]], "spacing": [2, 3]})",
      R"([{"golden": {"tolerance": {"k_shadow": 0.1}}}, {"reference": {"mismatch": [0, 0.1]}},
          {"probe": {"at": [1, 2], "b_shadow": 1}}, {"max_steps": 40}])");
  ASSERT_EQ(errors(whole), "");
  const std::string alphabet = "{}[]\",:0123456789.-eE \n\\utrunfalse/\xC3\xFF";
  Random random;
  int valid = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = whole;
    for (std::size_t edits = 1 + random.below(3); edits > 0; --edits) {
      const std::size_t at = random.below(damaged.size()), length = 1 + random.below(12);
      switch (random.below(4)) {
        case 0:
          damaged[at] = alphabet[random.below(alphabet.size())];
          break;
        case 1:
          damaged.erase(at, length);
          break;
        case 2:
          damaged.insert(at, damaged.substr(random.below(damaged.size()), length));
          break;
        default:
          damaged[at] = static_cast<char>(random.below(256));
          break;
      }
    }
    const LoadResult result = load(damaged);
    EXPECT_NE(result.tests.empty(), result.diagnostics.empty()) << damaged;
    valid += result.tests.empty() ? 0 : 1;
  }
  EXPECT_GT(valid, 10) << "some edits, such as of digits, do no harm";
}

}  // namespace
}  // namespace gnomon::scene
