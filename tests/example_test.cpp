// SPDX-License-Identifier: MIT
// examples/opengl, built against the installation, on three maps: not one pixel outside of the band may
// differ from the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

#include "image/image.h"
#include "shell.h"
#include "terrain/procedural.h"
#include "testing/run_command.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;

using testing::Ran;
using testing::run_command;

class Example : public ::testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// A procedural map as float EXR.
  [[nodiscard]] std::string write_map(const std::string& kind) const {
    const auto map =
        terrain::make_procedural({.kind = kind, .width = 256, .height = 200, .seed = 7, .parameters = {}});
    image::Image image{.width = map->width, .height = map->height, .channels = {}, .attributes = {}};
    image.channels["height"] = map->samples;
    EXPECT_TRUE(image::write_exr(path(kind + ".exr"), image).ok());
    return path(kind + ".exr");
  }

  void expect_shadow_of_oracle(const std::string& heights, const std::string& spacing,
                               const std::array<std::string, 3>& suns) const {
    for (const std::string& sun : suns) {
      SCOPED_TRACE(heights + ", sun " + sun);
      const std::string options = " --sun " + sun + " --spacing " + spacing;
      const Ran drawn = run_command(quote(EXAMPLE_PROGRAM) + " " + quote(heights) + " " +
                                    quote(path("actual.exr")) + options);
      ASSERT_EQ(drawn.code, 0) << drawn.output;
      const Ran known = run_command(quote(GNOMON_PROGRAM) + " render --method reference --heightmap " +
                                    quote(heights) + options + " -o " + quote(path("expected.exr")));
      ASSERT_EQ(known.code, 0) << known.output;
      const Ran compared = run_command(quote(GNOMON_PROGRAM) + " diff " + quote(path("actual.exr")) + " " +
                                       quote(path("expected.exr")) + " --channel b_shadow");
      EXPECT_EQ(compared.code, 0);
      std::printf("%s, sun %s: %s", fs::path(heights).stem().c_str(), sun.c_str(), compared.output.c_str());
      expect_both_light_and_shadow();
    }
  }

  /// Else the comparison would prove little.
  void expect_both_light_and_shadow() const {
    const Result<image::Image> image = image::read_image(path("actual.exr"));
    ASSERT_TRUE(image.ok());
    const std::vector<float>& shadow = image->channels.at("b_shadow");
    EXPECT_GT(std::ranges::count(shadow, 1.0F), std::ssize(shadow) / 100);
    EXPECT_GT(std::ranges::count(shadow, 0.0F), std::ssize(shadow) / 100);
  }

  fs::path folder_ =
      fs::path(::testing::TempDir()) /
      (std::string("example_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Example, FractalHasTheShadowOfTheOracle) {
  expect_shadow_of_oracle(write_map("fractal"), "1,1", {"45,2", "213.7,5", "315,20"});
}

TEST_F(Example, SpikesHaveTheShadowOfTheOracle) {
  expect_shadow_of_oracle(write_map("spikes"), "1,1", {"0,30", "251.7,5", "100,12"});
}

TEST_F(Example, RealModelHasTheShadowOfTheOracle) {
  expect_shadow_of_oracle(GNOMON_SOURCE_DIR "/testcases/terrain/jacksboro.png", "74.85,92.47",
                          {"118,9", "230.5,3", "315,20"});
}

TEST_F(Example, WritesAPicture) {
  const Ran drawn =
      run_command(quote(EXAMPLE_PROGRAM) + " " + quote(write_map("cone")) + " " + quote(path("cone.png")));
  ASSERT_EQ(drawn.code, 0) << drawn.output;
  const Result<image::Image> picture = image::read_image(path("cone.png"));
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->channels.size(), 3U);
  EXPECT_EQ(picture->width, 256);
  EXPECT_EQ(picture->height, 200);
}

TEST_F(Example, SaysWhatItCannotRead) {
  const Ran ran =
      run_command(quote(EXAMPLE_PROGRAM) + " " + quote(path("missing.exr")) + " " + quote(path("out.exr")));
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.output.find("missing.exr"), std::string::npos) << ran.output;
  EXPECT_FALSE(fs::exists(path("out.exr")));
}

TEST_F(Example, SaysWhatItCannotWrite) {
  const Ran ran = run_command(quote(EXAMPLE_PROGRAM) + " " + quote(write_map("cone")) + " " +
                              quote(path("none/out.exr")));
  EXPECT_EQ(ran.code, 1);
  EXPECT_NE(ran.output.find("No such file or directory"), std::string::npos) << ran.output;
}

}  // namespace
}  // namespace gnomon
