// SPDX-License-Identifier: MIT
// Every ready-made host on the GPU, in every dialect that a desktop driver runs: the heights that it answers
// are those of a decoder in C++ to the bit, and the shadow of the map is the oracle's.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "judge/judge.h"
#include "technique/reference.h"
#include "technique/renderer.h"
#include "testing/encoding.h"
#include "testing/engine_fixture.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using testing::Encoding;

/// How far outside of the map heights are asked, samples.
constexpr int kBeyond = 3;

/// An encoding and the dialect that the shaders are assembled in.
struct Case {
  Encoding encoding;
  std::string target;
};

class Host : public ::testing::TestWithParam<Case> {
 protected:
  void SetUp() override {
    ASSERT_TRUE(engine_.gl_info().ok());
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] static const Encoding& encoding() { return GetParam().encoding; }
  [[nodiscard]] static const std::string& target() { return GetParam().target; }

  /// A program of the host and `rest`.
  const technique::CachedProgram* program(const std::string& rest) {
    const fs::path file = folder_ / (std::to_string(files_++) + ".frag");
    std::ofstream(file) << encoding().prelude << "#include <gnomon/host/" << encoding().host << ".glsl>\n"
                        << rest;
    const auto made = programs_.get(file.string());
    EXPECT_TRUE(made.ok()) << to_string(made.diagnostics().front());
    return made.ok() ? *made : nullptr;
  }

  /// What the program writes into each of `size` pixels.
  std::vector<float> values(const std::string& rest, const testing::HostInputs& inputs, gl::Size size) {
    const technique::CachedProgram* made = program("layout(location = 0) out float o_value;\n" + rest);
    const Result<gl::Texture> texture = gl::Texture::create(gl::Format::kR32F, size);
    if (made == nullptr || !texture.ok()) return {};
    const Result<Done> drawn = gl::draw({.program = &made->program,
                                         .uniforms = inputs.uniforms(),
                                         .samplers = inputs.samplers(),
                                         .buffers = inputs.buffers(),
                                         .target = &texture.value()});
    EXPECT_TRUE(drawn.ok());
    return texture->download();
  }

  void expect_heights(const testing::Stored& stored, const testing::HostInputs& inputs) {
    const terrain::HeightMap& map = stored.decoded;
    const gl::Size size{map.width + 2 * kBeyond, map.height + 2 * kBeyond};
    const std::vector<float> heights =
        values("void main() { o_value = gnomon_host_height(ivec2(gl_FragCoord.xy) - " +
                   std::to_string(kBeyond) + ", 0); }\n",
               inputs, size);
    ASSERT_EQ(heights.size(), std::size_t(size.width) * std::size_t(size.height));
    int different = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const int row = std::clamp(y - kBeyond, 0, map.height - 1);
        const int column = std::clamp(x - kBeyond, 0, map.width - 1);
        const float actual = heights[std::size_t(y) * std::size_t(size.width) + std::size_t(x)];
        if (actual == map.at(row, column) || ++different > 3) continue;
        ADD_FAILURE() << "sample (" << column << ", " << row << "): " << actual << " instead of "
                      << map.at(row, column);
      }
    }
    EXPECT_EQ(different, 0);
  }

  void expect_shadow(scene::Scene scene, const technique::Pyramid& pyramid, const testing::Stored& stored,
                     const testing::HostInputs& inputs) {
    const technique::ShadowProgram with{
        .program = program("#include <gnomon/relief/multilevel.glsl>\n"
                           "#include <gnomon/programs/shadow_pass.glsl>\n"
                           "void main() { write_shadow(gnomon_multilevel(pass_map(), pass_receiver(), "
                           "u_to_sun, u_q, u_step_limit)); }\n"),
        .samplers = inputs.samplers(),
        .buffers = inputs.buffers(),
        .uniforms = inputs.uniforms()};
    ASSERT_NE(with.program, nullptr);
    for (const scene::Sun& sun : {scene::Sun{45, 2}, {213.7, 5}, {315, 20}, {180, 35}}) {
      scene.sun = sun;
      const technique::Ground ground = technique::map_ground({}, scene.shadow, stored.decoded);
      const auto actual = technique::render_shadow_with(with, pyramid, scene, ground);
      ASSERT_TRUE(actual.ok()) << to_string(actual.diagnostics().front());
      const image::Image expected = technique::reference_image(scene, stored.decoded, ground);
      const judge::Verdict verdict = judge::compare(*actual, expected, {.channels = {"b_shadow"}});
      EXPECT_TRUE(verdict.passed) << "azimuth " << sun.azimuth << ", elevation " << sun.elevation << ": "
                                  << verdict.measured;
      shadowed_ += std::ranges::count(expected.channels.at("b_shadow"), 1.0F);
      compared_ += verdict.compared;
    }
  }

  Engine engine_ = testing::make_engine();
  technique::ProgramCache programs_{
      compiler::Options{.library_directory = GNOMON_SOURCE_DIR "/shaderlib", .target = target()}};
  double compared_ = 0;
  std::ptrdiff_t shadowed_ = 0;

 private:
  fs::path folder_ = fs::path(::testing::TempDir()) / ("gnomon-host-" + std::to_string(::getpid()));
  int files_ = 0;
};

TEST_P(Host, HeightsAreThoseOfTheDecoderAndTheShadowIsTheOracles) {
  for (const char* kind : {"fractal", "gorge"}) {
    const scene::Scene scene = testing::scene_over(kind, 133, 70);
    const auto map = engine_.terrain(scene);
    ASSERT_TRUE(map.ok());
    const testing::Stored stored = encoding().store(**map);
    const auto pyramid = technique::build_pyramid(engine_.programs(), stored.decoded, 0);
    ASSERT_TRUE(pyramid.ok());
    const testing::HostInputs inputs(encoding(), stored, pyramid->extrema);
    expect_heights(stored, inputs);
    expect_shadow(scene, *pyramid, stored, inputs);
  }
  EXPECT_GT(compared_, 0.95 * 2 * 4 * 133 * 70);
  EXPECT_GT(double(shadowed_), 0.1 * compared_);
  EXPECT_LT(double(shadowed_), 0.9 * compared_);
}

/// Hosts that decode stored numbers.
class DecodingHost : public Host {};

TEST_P(DecodingHost, EveryNumberThatCanBeStoredIsDecodedToTheBit) {
  const Result<gl::Texture> no_extrema = gl::Texture::create(gl::Format::kR32F, {1, 1});
  ASSERT_TRUE(no_extrema.ok());
  const testing::Stored stored = encoding().store_everything();
  expect_heights(stored, testing::HostInputs(encoding(), stored, *no_extrema));
}

/// Hosts whose heights are a texture that says all.
class TextureHost : public Host {};

TEST_P(TextureHost, BlockMaximaOfAnEncodedTextureAreThoseOfItsMap) {
  const auto map = engine_.terrain(testing::scene_over("fractal", 133, 70));
  ASSERT_TRUE(map.ok());
  const testing::Stored stored = encoding().store(**map);
  const auto pyramid = technique::build_pyramid(engine_.programs(), stored.decoded, 0);
  ASSERT_TRUE(pyramid.ok());
  const technique::CachedProgram* made =
      program("#include <gnomon/programs/extrema_pass.glsl>\nvoid main() { write_extrema(); }\n");
  ASSERT_NE(made, nullptr);
  const testing::HostInputs inputs(encoding(), stored, pyramid->extrema);
  const auto extrema = technique::build_extrema(made->program, inputs.heights());
  ASSERT_TRUE(extrema.ok());
  ASSERT_EQ(extrema->levels(), pyramid->extrema.levels());
  for (int level = 0; level < extrema->levels(); ++level)
    EXPECT_EQ(extrema->download(level), pyramid->extrema.download(level)) << "mip level " << level;
}

std::vector<Case> cases(bool (*wanted)(const Encoding&)) {
  std::vector<Case> all;
  for (const Encoding& encoding : testing::encodings()) {
    if (!wanted(encoding)) continue;
    for (const std::string& target : encoding.targets) all.push_back({encoding, target});
  }
  return all;
}

std::string name_of(const ::testing::TestParamInfo<Case>& info) {
  return info.param.encoding.name + "_in_" + info.param.target;
}

INSTANTIATE_TEST_SUITE_P(Every, Host, ::testing::ValuesIn(cases([](const Encoding&) { return true; })),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Every, DecodingHost, ::testing::ValuesIn(cases([](const Encoding& encoding) {
                           return encoding.decode != nullptr;
                         })),
                         name_of);
INSTANTIATE_TEST_SUITE_P(Every, TextureHost, ::testing::ValuesIn(cases([](const Encoding& encoding) {
                           return encoding.layout == Encoding::Layout::kTexture && encoding.uniforms.empty();
                         })),
                         name_of);

}  // namespace
}  // namespace gnomon
