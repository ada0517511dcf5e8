// SPDX-License-Identifier: MIT
// The program's back ends and devices, and bench on them.
#include <gtest/gtest.h>

#include "image/image.h"
#include "testing/program_fixture.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

using testing::Gnomon;
using testing::Ran;

TEST_F(Gnomon, WithoutEglAndOsmesaGlIsNinetyNineAndTheOracleAnswers) {
  write_scene("a", R"([{"reference": {}}])");
  write("no_gl/libEGL.so.1", "no library");
  write("no_gl/libOSMesa.so.8", "no library");
  write("no_gl/libOSMesa.so.6", "no library");
  setenv("LD_LIBRARY_PATH", (root_ / "no_gl").c_str(), 1);
  const Ran ran = run("render testcases/a.json -o o.exr");
  EXPECT_EQ(ran.code, 99);
  for (const char* package : {"libegl1", "libegl-mesa0", "libgl1-mesa-dri", "libosmesa6"})
    EXPECT_SAYS(ran, package);
  EXPECT_EQ(run("render testcases/a.json --backend cpu -o o.exr").code, 0);
  EXPECT_EQ(run("render testcases/a.json --backend egl --set shadow.method=reference -o o.exr").code, 99);
  const Ran test = run("test --backend osmesa");
  EXPECT_EQ(test.code, 99);
  EXPECT_SAYS(test, "'--backend osmesa': libOSMesa.so.8 cannot be loaded");
  EXPECT_SAYS(test, "libosmesa6");
  const Ran info = run("info");
  EXPECT_EQ(info.code, 99);
  EXPECT_SAYS(info, "back end osmesa    absent");
  unsetenv("LD_LIBRARY_PATH");
}

TEST_F(Gnomon, WithoutAnEglDriverAutoTakesOsmesaAndSaysWhy) {
  write_scene("a", R"([{"reference": {}}])");
  ASSERT_EQ(run("test --backend osmesa").code, 0) << "scripts/setup installs OSMesa";
  setenv("__EGL_VENDOR_LIBRARY_DIRS", "/nonexistent", 1);
  EXPECT_EQ(run("test").code, 0);
  EXPECT_EQ(run("test --backend egl").code, 99);
  const Ran info = run("info");
  EXPECT_EQ(info.code, 0);
  EXPECT_SAYS(info, "back end egl       absent: libEGL.so.1 has no driver");
  EXPECT_SAYS(info, "auto takes         device 0: EGL offers no device");
  unsetenv("__EGL_VENDOR_LIBRARY_DIRS");
}

TEST_F(Gnomon, DeviceReachesTheWorkersAndTheCommandThatReproduces) {
  write_scene("a", R"([{"probe": {"at": [0, 0], "b_shadow": 7}}])");
  const Ran ran = run("test --device 0");
  EXPECT_EQ(ran.code, 1);
  EXPECT_SAYS(ran, "--device 0\n");
  const Ran none = run("test --device geforce");
  EXPECT_EQ(none.code, 99);
  EXPECT_SAYS(none, "'--device geforce' matches none of the devices");
  EXPECT_SAYS(none, "device 0 ");
  EXPECT_EQ(run("render testcases/a.json --device geforce -o o.exr").code, 99);
  EXPECT_FALSE(fs::exists(root_ / "o.exr"));
  EXPECT_EQ(run("bench --size 64 --rounds 1 --device geforce").code, 99);
  EXPECT_EQ(run("bench --backend cpu").code, 2);
  EXPECT_EQ(run("test --backend cpu --device 0").code, 2);
  EXPECT_EQ(run("test --backend vulkan").code, 2);
}

TEST_F(Gnomon, ReferenceNeedsNoOpenGl) {
  write_scene("a", R"([{"reference": {}}])");
  const Ran ran = run("render testcases/a.json --set shadow.method=reference -o a.exr");
  EXPECT_EQ(ran.code, 0) << ran.output;
  EXPECT_TRUE(image::read_image((root_ / "a.exr").string())->channel("horizon"));
}

TEST_F(Gnomon, BenchJudgesCascadesAndSaysWhereNothingCanBeWritten) {
  const Ran ran =
      run("bench --experiment cascades --size 64 --rounds 1 --json figures.json --pictures pictures");
  EXPECT_EQ(ran.code, 0) << ran.output << "methods that are exact differ nowhere";
  const std::string figures = read("figures.json");
  for (const char* part : {"\"map\": \"far background\"", "\"cascade_size\": 4096", "\"faces\": \"front\""})
    EXPECT_NE(figures.find(part), std::string::npos) << part;
  EXPECT_GT(std::distance(fs::directory_iterator(root_ / "pictures"), {}), 30);
  EXPECT_EQ(run("bench --size 64 --json nowhere/figures.json").code, 99);
  EXPECT_EQ(run("bench --size 64 --pictures figures.json").code, 99);
  EXPECT_EQ(run("bench --size 64 --scene testcases/map.json").code, 2) << "methods has no map to add to";
}

TEST_F(Gnomon, BenchOffersOnlyBackEndsThatItTakes) {
  const Ran help = run("bench --help");
  EXPECT_EQ(help.code, 0);
  EXPECT_SAYS(help, "osmesa. Default auto");
  EXPECT_EQ(help.output.find("cpu"), std::string::npos) << help.output;
  const Ran cpu = run("bench --backend cpu");
  EXPECT_EQ(cpu.code, 2);
  EXPECT_SAYS(cpu, "--backend: bench times OpenGL methods, which 'cpu' has none of");
  const Ran nonsense = run("bench --backend vulkan");
  EXPECT_EQ(nonsense.code, 2);
  EXPECT_SAYS(nonsense, "'vulkan' is not one of auto, egl, osmesa\n");
  EXPECT_SAYS(run("render --help"), "cpu: the oracle");
}

TEST_F(Gnomon, BenchWritesNothingButJsonOnStandardOutputWhereThatIsAskedFor) {
  const Ran ran = run("bench --size 64 --rounds 1 --json - 2> tables");
  EXPECT_EQ(ran.code, 0) << ran.output;
  EXPECT_EQ(ran.output.rfind("{\n", 0), 0u) << ran.output;
  EXPECT_EQ(ran.output.substr(ran.output.size() - 2), "}\n");
  EXPECT_SAYS(ran, "\"experiment\": \"methods\"");
  EXPECT_NE(read("tables").find("median ms"), std::string::npos);
  EXPECT_FALSE(fs::exists(root_ / "-"));
}

}  // namespace
}  // namespace gnomon
