// SPDX-License-Identifier: MIT
// gnomon trace: the steps that it prints are those that the GPU took, and it answers as a command should.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>

#include "shell.h"
#include "testing/engine_fixture.h"
#include "testing/run_command.h"
#include "trace/trace.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::Ran;

struct Tally {
  int traced = 0, steps = 0, elsewhere = 0;
};

/// Traces pixels all over the image. Where the GPU's view ray ended in other digits, its point is asked
/// instead of the pixel.
void expect_steps_of_the_gpu(Engine& engine, const scene::Scene& scene, Tally& tally, int count = 80) {
  const Result<Rendered> rendered = engine.render(scene);
  ASSERT_TRUE(rendered.ok()) << to_string(rendered.diagnostics().front());
  const image::Image& image = rendered->image;
  for (int i = 0; i < count; ++i) {
    const glm::ivec2 pixel((i * 7919) % image.width, (i * 104729) % image.height);
    const auto index = static_cast<std::size_t>(pixel.y * image.width + pixel.x);
    const Result<trace::Trace> trace = trace::trace_pixel(scene, *rendered->map, pixel);
    ASSERT_TRUE(trace.ok()) << to_string(trace.diagnostics().front());
    const technique::Ground& asked = trace->point.ground;
    const technique::Ground& gpu = rendered->ground;
    ASSERT_EQ(asked.valid[0], gpu.valid[index]) << pixel.x << ' ' << pixel.y;
    if (!trace->walk) continue;
    EXPECT_NEAR(asked.column[0], gpu.column[index], 1e-3);
    EXPECT_NEAR(asked.row[0], gpu.row[index], 1e-3);
    EXPECT_EQ(asked.q[0], gpu.q[index]);
    if (asked.column[0] != gpu.column[index] || asked.row[0] != gpu.row[index]) {
      ++tally.elsewhere;
      continue;
    }
    EXPECT_EQ(trace->walk->count, image.channels.at("steps")[index])
        << scene.id << ' ' << pixel.x << ' ' << pixel.y;
    EXPECT_EQ(trace->walk->steps.size(), static_cast<std::size_t>(trace->walk->count));
    EXPECT_EQ(trace->walk->shadow, image.channels.at("b_shadow")[index]);
    ++tally.traced;
    tally.steps += trace->walk->count;
  }
}

void print(const char* what, const Tally& tally) {
  std::cout << what << ": " << tally.traced << " pixels, " << tally.steps << " steps, " << tally.elsewhere
            << " seen elsewhere by the GPU\n";
}

TEST(Trace, StepsAreThoseOfTheGpuOnMaps) {
  Engine engine = testing::make_engine();
  Tally tally;
  for (const std::string map : {"fractal", "spikes", "real"}) {
    for (const std::string method : {"multilevel", "multilevel_literal", "brute_force"}) {
      for (const int q : {0, 2}) {
        scene::Scene scene = testing::scene_over(map, 133, 95);
        scene.sun = {213.7, 6};
        scene.shadow.method = method;
        scene.shadow.q = q;
        scene.shadow.receiver_height = map == "spikes" ? 0.5 : 0.0;
        if (map == "real") scene.camera = scene::MapCamera{.size = {{201, 160}}};
        expect_steps_of_the_gpu(engine, scene, tally);
      }
    }
  }
  print("map cameras", tally);
  EXPECT_EQ(tally.traced, 3 * 3 * 2 * 80);
  EXPECT_GT(tally.steps, 10 * tally.traced);
}

/// Random heights, a tenth of them missing.
scene::Scene with_holes(int width, int height) {
  scene::Scene scene;
  scene.id = scene.file = "holes";
  scene::InlineTerrain table{width, height, {}};
  std::mt19937 random(5);
  for (int i = 0; i < width * height; ++i)
    table.heights.push_back(random() % 10 == 0 ? scene::InlineTerrain::kNull
                                               : static_cast<double>(random() % 64));
  scene.terrain.source = table;
  scene.terrain.spacing = {{20, 15}};
  return scene;
}

TEST(Trace, StepsAreThoseOfTheGpuAmongHoles) {
  Engine engine = testing::make_engine();
  Tally tally;
  scene::Scene scene = with_holes(57, 43);
  for (const double azimuth : {0.0, 90.0, 45.0, 123.4}) {
    for (const int q : {0, 1}) {
      for (const std::string method : {"multilevel", "multilevel_literal", "brute_force"}) {
        scene.sun = {azimuth, 4};
        scene.shadow.q = q;
        scene.shadow.method = method;
        expect_steps_of_the_gpu(engine, scene, tally);
      }
    }
  }
  print("holes", tally);
  EXPECT_GT(tally.traced, 500);
}

/// A fractal map before a camera.
scene::Scene seen_fractal(bool perspective) {
  scene::Scene scene = testing::scene_over("fractal", 200, 150);
  scene.sun = {130, 8};
  scene.camera = scene::ViewCamera{.projection = perspective ? scene::ViewCamera::Projection::kPerspective
                                                             : scene::ViewCamera::Projection::kOrthographic,
                                   .eye = {1000, -900, 1200},
                                   .target = {1000, 800, 100},
                                   .extent = perspective ? 50.0 : 1500.0,
                                   .size = {160, 120}};
  return scene;
}

TEST(Trace, StepsAreThoseOfTheGpuUnderCameras) {
  Engine engine = testing::make_engine();
  Tally tally;
  for (const bool perspective : {true, false}) {
    for (const std::optional<int> q : {std::optional<int>(0), std::optional<int>(1), std::optional<int>()}) {
      scene::Scene scene = seen_fractal(perspective);
      scene.shadow.q = q;
      expect_steps_of_the_gpu(engine, scene, tally, 220);
    }
  }
  print("views", tally);
  EXPECT_GT(tally.traced, 500);
  EXPECT_LT(tally.elsewhere, tally.traced / 10);
}

/// What trace says of a mesh's view ray is told of the very pixel, and what its cell and triangle say.
void expect_true_view(const trace::Trace& trace, const terrain::HeightMap& map, int step) {
  ASSERT_TRUE(trace.point.mesh);
  const trace::MeshView& view = *trace.point.mesh;
  ASSERT_EQ(view.triangle.has_value(), trace.point.valid());
  if (!view.triangle) return;
  const double column = double{trace.point.ground.column[0]}, row = double{trace.point.ground.row[0]};
  const auto& [at, columns, rows, north_western] = *view.triangle;
  EXPECT_EQ(static_cast<float>(at[0]), trace.point.ground.column[0]);
  EXPECT_EQ(static_cast<float>(at[1]), trace.point.ground.row[0]);
  const double rounding = 1e-6 * std::max(map.width, map.height);
  EXPECT_LE(columns[0], column + rounding);
  EXPECT_GE(columns[1], column - rounding);
  EXPECT_LE(rows[0], row + rounding);
  EXPECT_GE(rows[1], row - rounding);
  EXPECT_LE(columns[1] - columns[0], step);
  // Beside or on the diagonal from the south-western to the north-eastern node.
  const double beyond =
      (column - columns[0]) / (columns[1] - columns[0]) + (row - rows[0]) / (rows[1] - rows[0]) - 1;
  EXPECT_TRUE(north_western ? beyond <= 2 * rounding : beyond >= -2 * rounding) << column << ' ' << row;
}

TEST(Trace, ViewRaysOfMeshesMeetWhatIsRendered) {
  Engine engine = testing::make_engine();
  int seen = 0, beside = 0, sky = 0, halves[2] = {0, 0};
  for (const bool perspective : {true, false}) {
    for (const int step : {1, 7}) {
      scene::Scene scene = seen_fractal(perspective);
      std::get<scene::ViewCamera>(scene.camera).mesh = scene::MeshSurface{.step = step};
      const Result<Rendered> rendered = engine.render(scene);
      ASSERT_TRUE(rendered.ok()) << to_string(rendered.diagnostics().front());
      const image::Image& image = rendered->image;
      for (int i = 0; i < 220; ++i) {
        const glm::ivec2 pixel((i * 7919) % image.width, (i * 104729) % image.height);
        const auto index = static_cast<std::size_t>(pixel.y * image.width + pixel.x);
        const Result<trace::Trace> trace = trace::trace_pixel(scene, *rendered->map, pixel);
        ASSERT_TRUE(trace.ok()) << to_string(trace.diagnostics().front());
        expect_true_view(*trace, *rendered->map, step);
        sky += !trace->point.valid();
        beside += trace->point.valid() != (image.channels.at("valid")[index] != 0);
        if (!trace->point.valid() || image.channels.at("valid")[index] == 0) continue;
        ++seen;
        ++halves[trace->point.mesh->triangle->north_western];
        // A ray that grazes a ridge may end before or behind it, in single precision or in double.
        const double depth = double{image.channels.at("depth")[index]};
        const double apart = std::hypot(image.channels.at("column")[index] - trace->point.ground.column[0],
                                        image.channels.at("row")[index] - trace->point.ground.row[0]);
        beside += std::abs(trace->point.mesh->depth - depth) > 1e-4 * depth || apart > 0.02;
      }
    }
  }
  std::cout << "meshes: " << seen << " pixels, " << beside << " seen elsewhere by the GPU, " << sky
            << " sky\n";
  EXPECT_GT(seen, 400);
  EXPECT_LT(beside, seen / 100);
  EXPECT_GT(std::min({halves[0], halves[1], sky}), 10);
}

class TraceCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(::testing::TempDir()) /
            (std::string("gnomon_trace_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(root_);
    fs::create_directories(root_ / "testcases");
    write("gnomon.json", R"({"version": 1})");
    write("testcases/one.json", scene(""));
    write("testcases/many.json", scene(R"("matrix": {"sun.elevation": [5, 20]},)"));
  }
  void TearDown() override { fs::remove_all(root_); }

  static std::string scene(const std::string& more) {
    return R"({"version": 1, "description": "d", "terrain": {"procedural": "fractal", "size": [64, 48], "spacing": 10},
               "sun": {"azimuth": 200, "elevation": 10}, )" +
           more + R"("expect": [{"reference": {}}]})";
  }
  void write(const std::string& name, const std::string& text) const { std::ofstream(root_ / name) << text; }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(root_ / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] Ran trace(const std::string& arguments) const {
    return testing::run_command("cd " + quote(root_.string()) + " && " + quote(GNOMON_PROGRAM) + " trace " +
                                arguments);
  }

  fs::path root_;
};

TEST_F(TraceCommand, PrintsHeaderStepsAndVerdict) {
  const Ran ran = trace("testcases/one.json --pixel 20,30 --json o.json");
  EXPECT_EQ(ran.code, 0) << ran.output;
  EXPECT_EQ(ran.output.rfind("one: pixel (20, 30) of 64 x 48\n", 0), 0u) << ran.output;
  EXPECT_SAYS(ran, "azimuth 200, elevation 10 degrees");
  const std::string last = ran.output.substr(ran.output.rfind("\n", ran.output.size() - 2) + 1);
  EXPECT_EQ(last.rfind("verdict: ", 0), 0u) << last;
  std::ifstream file(root_ / "o.json");
  const nlohmann::json json = nlohmann::json::parse(file);
  EXPECT_EQ(json["scene"], "one");
  EXPECT_EQ(json["walk"].size(), json["steps"]);
}

TEST_F(TraceCommand, ADashIsStandardOutputWithNothingButJson) {
  ASSERT_EQ(trace("testcases/one.json --pixel 20,30 --json o.json > text").code, 0);
  const Ran ran = trace("testcases/one.json --pixel 20,30 --json - 2> told");
  EXPECT_EQ(ran.code, 0);
  EXPECT_EQ(ran.output, read("o.json"));
  EXPECT_EQ(read("told"), read("text")) << "people read it on standard error";
  EXPECT_FALSE(fs::exists(root_ / "-"));
  EXPECT_EQ(trace("testcases/one.json --pixel 20,30 --json - > /dev/full").code, 99);
  EXPECT_EQ(trace("testcases/one.json --pixel 20,30 --json ./-").code, 0);
  EXPECT_EQ(read("-"), read("o.json"));
}

// A plain 5 m high, seen straight down from 105 m: nodes on the samples, cells cut from south-west to
// north-east.
TEST_F(TraceCommand, PrintsWhereTheViewRayMeetsTheMesh) {
  std::string heights = "[5, 5, 5, 5]";
  heights = "[" + heights + "," + heights + "," + heights + "," + heights + "]";
  write("testcases/mesh.json",
        R"({"version": 1, "description": "d", "terrain": {"heights": )" + heights + R"(, "spacing": 10},
            "sun": {"azimuth": 200, "elevation": 10}, "expect": [{"reference": {}}],
            "camera": {"orthographic": {"eye": [20, 20, 105], "target": [20, 20, 5], "height": 60,
                                        "size": [60, 60], "surface": "mesh"}}})");
  const Ran ran = trace("testcases/mesh.json --pixel 26,22 --json o.json");
  EXPECT_EQ(ran.code, 0);
  EXPECT_SAYS(
      ran,
      "view     the view ray meets the mesh after 100 m at column 1.65, row 1.25, in the north-western "
      "triangle of the cell from column 1.5 to 2.5, row 0.5 to 1.5; ");
  nlohmann::json view = nlohmann::json::parse(read("o.json"))["view"];
  EXPECT_NEAR(view["depth"].get<double>(), 100, 1e-9);
  EXPECT_EQ(view["cell"], nlohmann::json({{"columns", {1.5, 2.5}}, {"rows", {0.5, 1.5}}}));
  EXPECT_EQ(view["triangle"], "north_west");
  EXPECT_NEAR(view["oracle"][0].get<double>(), 1.65, 1e-9);
  EXPECT_NEAR(view["oracle"][1].get<double>(), 1.25, 1e-9);
  EXPECT_SAYS(trace("testcases/mesh.json --pixel 33,23"), "row 1.35, in the south-eastern triangle");
  const Ran sky = trace("testcases/mesh.json --pixel 1,1 --json o.json");
  EXPECT_EQ(sky.code, 0);
  EXPECT_SAYS(sky, "view     the view ray meets no triangle of the mesh\n");
  view = nlohmann::json::parse(read("o.json"))["view"];
  EXPECT_EQ(view,
            nlohmann::json({{"depth", 0.0}, {"oracle", nullptr}, {"cell", nullptr}, {"triangle", nullptr}}));
}

TEST_F(TraceCommand, MethodAndSetChangeWhatIsTraced) {
  EXPECT_SAYS(trace("testcases/one.json --pixel 20,30 --method brute_force"), "method   brute_force");
  EXPECT_SAYS(trace("testcases/one.json --pixel 20,30 --set sun.elevation=3"), "elevation 3 degrees");
}

TEST_F(TraceCommand, ASceneWithSeveralTestsNeedsAFilter) {
  const Ran ran = trace("testcases/many.json --pixel 1,2");
  EXPECT_EQ(ran.code, 2);
  EXPECT_SAYS(
      ran,
      "many.json: error: makes 2 tests; pick one with --filter:\n  many@elevation=5\n  many@elevation=20");
  const Ran one = trace("testcases/many.json --pixel 1,2 --filter '*=20'");
  EXPECT_EQ(one.code, 0) << one.output;
  EXPECT_SAYS(one, "many@elevation=20: pixel (1, 2)");
  const Ran none = trace("testcases/many.json --pixel 1,2 --filter '*=7'");
  EXPECT_EQ(none.code, 2);
  EXPECT_SAYS(none, "--filter: error: matches no test of the scene; it makes\n  many@elevation=5");
}

TEST_F(TraceCommand, WrongUsageIsTwoAndSaysWhatIsRight) {
  for (const auto& [arguments, says] :
       {std::pair{"testcases/one.json", "--pixel is required"},
        {"--pixel 1,2", "SCENE is required"},
        {"testcases/one.json --pixel 1", "'1' is not X,Y"},
        {"testcases/one.json --pixel 1,x", "'x' is not X,Y"},
        {"testcases/one.json --pixel 64,0",
         "has no pixel (64, 0); it has the columns 0 to 63 and the rows 0 to 47"},
        {"testcases/one.json --pixel 1,2 --method reference", "'reference' has no steps that could be told"},
        {"testcases/one.json --pixel 1,2 --method nonsense", "'nonsense' is not one of"},
        {"testcases/one.json --pixel 1,2 --set shadow.method=reference", "name one that has with --method"},
        {"testcases/one.json --pixel 1,2 --set shadow.q=9", "coarsest level of a 64x48 map is L = 6"},
        {"testcases/one.json --pixel 1,2 --nonsense", "--nonsense"},
        {"testcases/missing.json --pixel 1,2", "there is no such file"},
        {"testcases/one.json --pixel 1,2 --json testcases/one.json", "is what is traced"}}) {
    const Ran ran = trace(arguments);
    EXPECT_EQ(ran.code, 2) << arguments << ran.output;
    EXPECT_SAYS(ran, says);
  }
  EXPECT_EQ(trace("testcases/one.json --pixel 1,2 --json missing/o.json").code, 99);
  EXPECT_EQ(trace("testcases/one.json --pixel 1,2").code, 0) << "the scene is still there";
}

}  // namespace
}  // namespace gnomon
