// SPDX-License-Identifier: MIT
// The modules give the same shadow in every GLSL dialect that the driver runs.
#include <gtest/gtest.h>

#include <array>

#include "testing/engine_fixture.h"

namespace gnomon {
namespace {

constexpr std::array<std::array<double, 2>, 3> kSuns{
    {{90, 2}, {213.7, 10}, {315, 35}}};  // azimuth, elevation

std::vector<scene::Scene> scenes() {
  std::vector<scene::Scene> list;
  for (const char* map : {"fractal", "spikes", "real"}) {
    for (const char* method : {"multilevel", "brute_force", "multilevel_literal"}) {
      for (const auto& [azimuth, elevation] : kSuns) {
        list.push_back(testing::scene_over(map, 256, 256));
        list.back().sun = {azimuth, elevation};
        list.back().shadow.method = method;
        list.back().shadow.q = elevation > 20 ? 2 : 0;
      }
    }
  }
  return list;
}

std::vector<float> shadows_of(Engine& engine, const scene::Scene& scene) {
  const Result<Rendered> rendered = engine.render(scene);
  if (rendered) return rendered->image.channels.at("b_shadow");
  ADD_FAILURE() << to_string(rendered.diagnostics().front());
  return {};
}

class Dialect : public ::testing::TestWithParam<std::string> {};

TEST_P(Dialect, ShadowsAreThoseOfGlsl450) {
  std::vector<std::vector<float>> expected;
  {
    Engine engine = testing::make_engine();
    for (const scene::Scene& scene : scenes()) expected.push_back(shadows_of(engine, scene));
  }
  Engine engine = testing::make_engine(GetParam());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const scene::Scene scene = scenes()[i];
    ASSERT_FALSE(expected[i].empty());
    EXPECT_TRUE(shadows_of(engine, scene) == expected[i])
        << scene.id << ", " << scene.shadow.method << ", azimuth " << scene.sun.azimuth;
  }
}

INSTANTIATE_TEST_SUITE_P(Texts, Dialect, ::testing::Values("glsl330", "essl300", "essl310"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace gnomon
