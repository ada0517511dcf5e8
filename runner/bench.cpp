// SPDX-License-Identifier: MIT
#include "bench.h"

#include <algorithm>
#include <chrono>
#include <numeric>

#include "judge/judge.h"
#include "technique/renderer.h"
#include "technique/technique.h"

namespace gnomon {
namespace {

scene::Scene scene_of(const BenchOptions& options) {
  scene::Scene scene;
  scene.file = "bench";
  scene.terrain.source = scene::ProceduralTerrain{
      .kind = "fractal", .width = options.size, .height = options.size, .seed = 1, .parameters = {}};
  scene.sun = {.azimuth = options.azimuth, .elevation = options.elevation};
  return scene;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Seconds, without compiling the two programs that build it.
Result<double> build_pyramid(Engine& engine, const std::shared_ptr<const terrain::HeightMap>& map) {
  for (const char* program : {"programs/level.frag", "programs/extrema.frag"}) {
    if (const auto ready = engine.programs().get(program); !ready) return ready.diagnostics();
  }
  const auto begin = std::chrono::steady_clock::now();
  const Result<const technique::Pyramid*> pyramid = engine.pyramid(map, 0);
  if (!pyramid) return pyramid.diagnostics();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void judge_figure(BenchFigure& figure, const image::Image& image, const image::Image& reference) {
  const judge::Verdict verdict = judge::compare(image, reference, {.channels = {"b_shadow"}});
  figure.mismatches = verdict.mismatches;
  figure.in_band = verdict.in_band;
  const std::vector<float>& steps = image.channels.at("steps");
  figure.mean_steps = std::accumulate(steps.begin(), steps.end(), 0.0) / static_cast<double>(steps.size());
}

}  // namespace

Result<BenchResult> bench(Engine& engine, const BenchOptions& options) {
  if (const Result<const gl::Info*> info = engine.gl_info(); !info) return info.diagnostics();
  scene::Scene scene = scene_of(options);
  const Result<std::shared_ptr<const terrain::HeightMap>> map = engine.terrain(scene);
  if (!map) return map.diagnostics();
  const Result<double> built = build_pyramid(engine, *map);
  if (!built) return built.diagnostics();
  const technique::Ground ground = technique::map_ground({}, scene.shadow, **map);
  const Result<image::Image> reference = engine.reference(scene, ground);
  if (!reference) return reference.diagnostics();

  BenchResult result{.options = options,
                     .pyramid_seconds = *built,
                     .rays = static_cast<double>(reference->pixels()),
                     .figures = {}};
  for (const technique::Technique& technique : technique::techniques()) {
    if (!technique.program.empty()) result.figures.push_back({.method = technique.name, .seconds = {}});
  }
  // The first round compiles and warms up; it is judged, but not timed.
  for (int round = 0; round <= options.rounds; ++round) {
    for (BenchFigure& figure : result.figures) {
      scene.shadow.method = figure.method;
      const Result<const technique::Pyramid*> pyramid =
          engine.pyramid(*map, 0, technique::find_technique(figure.method)->bounds);
      if (!pyramid) return pyramid.diagnostics();
      double seconds = 0;
      const Result<image::Image> image =
          technique::render_shadow(engine.programs(), {{0, *pyramid}}, scene, ground, &seconds);
      if (!image) return image.diagnostics();
      if (round == 0) judge_figure(figure, *image, *reference);
      if (round > 0) figure.seconds.push_back(seconds);
    }
  }
  for (BenchFigure& figure : result.figures) figure.median = median(figure.seconds);
  return result;
}

}  // namespace gnomon
