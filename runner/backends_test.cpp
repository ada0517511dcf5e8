// SPDX-License-Identifier: MIT
// Scenes of the suite on both back ends in turn: every channel the same, bit for bit. Skipped where this
// machine lacks one of them.
#include <gtest/gtest.h>

#include <bit>
#include <iostream>
#include <optional>

#include "cli/commands.h"
#include "engine.h"
#include "scene/load.h"

namespace gnomon {
namespace {

constexpr const char* kScenes[] = {
    "analytic/cone",         "analytic/plane_exact_tie", "levels/fractal", "levels/jacksboro",
    "metamorphic/turned_90", "odd/camera_size",          "odd/one_row",    "odd/spacing",
    "real/jacksboro",        "receivers/levels",         "stress/gorge",   "stress/spikes"};

std::vector<scene::Scene> scenes() {
  std::vector<scene::Scene> list;
  for (const char* name : kScenes) {
    const std::string file = std::string(GNOMON_SOURCE_DIR "/testcases/") + name + ".json";
    scene::LoadResult loaded = scene::load_scene(file, {}, cli::vocabulary());
    for (const Diagnostic& wrong : loaded.diagnostics) ADD_FAILURE() << to_string(wrong);
    list.insert(list.end(), loaded.tests.begin(), loaded.tests.end());
  }
  return list;
}

/// Software of both: what hardware rounds otherwise is not the question here.
EngineOptions options(Backend backend) {
  return {.shader_library = GNOMON_SOURCE_DIR "/shaderlib", .backend = backend, .device = "llvmpipe"};
}

/// Why a back end cannot be asked; empty: it can.
std::string lacks(Backend backend) {
  const Result<const gl::Info*> info = Engine(options(backend)).gl_info();
  return info ? std::string() : to_string(info.diagnostics().front());
}

std::vector<image::Image> images_of(Backend backend, const std::vector<scene::Scene>& asked) {
  Engine engine(options(backend));
  std::vector<image::Image> images;
  for (const scene::Scene& scene : asked) {
    Result<Rendered> rendered = engine.render(scene);
    EXPECT_TRUE(rendered) << to_string(rendered.diagnostics().front());
    images.push_back(rendered ? std::move(rendered->image) : image::Image{});
  }
  return images;
}

bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return std::ranges::equal(
      a, b, {}, [](float v) { return std::bit_cast<std::uint32_t>(v); },
      [](float v) { return std::bit_cast<std::uint32_t>(v); });
}

TEST(Backends, EveryChannelIsTheSameOnEglAndOsmesa) {
  for (const Backend backend : {Backend::kEgl, Backend::kOsmesa}) {
    // scripts/setup installs both: a machine that lacks one tests nothing here.
    ASSERT_EQ(lacks(backend), "");
  }
  const std::vector<scene::Scene> asked = scenes();
  const std::vector<image::Image> egl = images_of(Backend::kEgl, asked);
  const std::vector<image::Image> osmesa = images_of(Backend::kOsmesa, asked);
  const std::vector<image::Image> again = images_of(Backend::kEgl, asked);  // nothing of OSMesa stays behind
  std::size_t values = 0;
  for (std::size_t i = 0; i < asked.size(); ++i) {
    ASSERT_FALSE(egl[i].channels.empty());
    ASSERT_EQ(egl[i].channels.size(), osmesa[i].channels.size());
    for (const auto& [name, channel] : egl[i].channels) {
      ASSERT_TRUE(osmesa[i].channel(name) && again[i].channel(name)) << name;
      EXPECT_TRUE(same_bits(channel, *osmesa[i].channel(name))) << asked[i].id << ", " << name;
      EXPECT_TRUE(same_bits(channel, *again[i].channel(name))) << asked[i].id << ", " << name;
      values += channel.size();
    }
  }
  std::cout << asked.size() << " images, " << values << " values the same on EGL and OSMesa\n";
}

}  // namespace
}  // namespace gnomon
