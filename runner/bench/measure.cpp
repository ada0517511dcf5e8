// SPDX-License-Identifier: MIT
#include "bench/measure.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>

#include "judge/judge.h"
#include "technique/renderer.h"
#include "technique/technique.h"

namespace gnomon::bench {
namespace {

using Map = std::shared_ptr<const terrain::HeightMap>;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Seconds, without compiling the two programs that build it.
Result<double> build_pyramid(Engine& engine, const Map& map) {
  for (const char* program : {"programs/level.frag", "programs/extrema.frag"}) {
    if (const auto ready = engine.programs().get(program); !ready) return ready.diagnostics();
  }
  const auto begin = std::chrono::steady_clock::now();
  const Result<const technique::Pyramid*> pyramid = engine.pyramid(map, 0);
  if (!pyramid) return pyramid.diagnostics();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

struct Drawn {
  technique::Ground ground;
  image::Image image;
  double view_seconds = 0;
  double seconds = 0;
};

Result<technique::Ground> ground_of(Engine& engine, const Map& map, const scene::Scene& scene,
                                    double& seconds) {
  if (const auto* camera = std::get_if<scene::MapCamera>(&scene.camera))
    return technique::map_ground(*camera, scene.shadow, *map);
  const Result<const technique::Pyramid*> base = engine.pyramid(map, 0);
  if (!base) return base.diagnostics();
  Result<technique::Ground> seen = technique::seen_ground(
      engine.programs(), **base, std::get<scene::ViewCamera>(scene.camera), scene.shadow, {}, &seconds);
  return seen;
}

Result<Drawn> draw(Engine& engine, const Map& map, const scene::Scene& scene) {
  double view_seconds = 0;
  Result<technique::Ground> ground = ground_of(engine, map, scene, view_seconds);
  if (!ground) return ground.diagnostics();
  technique::leave_out_holes(*ground, *map);
  technique::Pyramids pyramids;
  for (const int q : ground->levels()) {
    const Result<const technique::Pyramid*> pyramid =
        engine.pyramid(map, q, technique::find_technique(scene.shadow.method)->bounds);
    if (!pyramid) return pyramid.diagnostics();
    pyramids[q] = *pyramid;
  }
  double seconds = 0;
  Result<image::Image> image =
      technique::render_shadow(engine.programs(), pyramids, scene, *ground, &seconds);
  if (!image) return image.diagnostics();
  return Drawn{std::move(ground).value(), std::move(image).value(), view_seconds, seconds};
}

Result<Done> judge_figure(Engine& engine, const Trial& trial, const Drawn& drawn, Figure& figure) {
  const Result<image::Image> reference = engine.reference(trial.scene, drawn.ground);
  if (!reference) return reference.diagnostics();
  const judge::Verdict verdict = judge::compare(drawn.image, *reference, {.channels = {"b_shadow"}});
  figure.mismatches = verdict.mismatches;
  figure.in_band = verdict.in_band;
  return Done{};
}

void count(const Drawn& drawn, const std::vector<float>& first, Figure& figure) {
  const std::vector<float>&valid = drawn.image.channels.at("valid"),
        &shadow = drawn.image.channels.at("b_shadow"), &steps = drawn.image.channels.at("steps");
  for (std::size_t i = 0; i < valid.size(); ++i) {
    if (valid[i] == 0) continue;
    ++figure.pixels;
    figure.mean_steps += double{steps[i]};
    figure.changed += shadow[i] != first[i] ? 1 : 0;
  }
  figure.mean_steps /= std::max(figure.pixels, 1.0);
}

/// Warms up: compiles programs, builds pyramids; and says what the images hold.
Result<Done> judge_round(Engine& engine, const Map& map, const Group& group, std::vector<Figure>& figures) {
  std::vector<float> first;
  for (std::size_t i = 0; i < group.trials.size(); ++i) {
    const Result<Drawn> drawn = draw(engine, map, group.trials[i].scene);
    if (!drawn) return drawn.diagnostics();
    if (i == 0) first = drawn->image.channels.at("b_shadow");
    count(*drawn, first, figures[i]);
    if (!group.judged) continue;
    if (const auto judged = judge_figure(engine, group.trials[i], *drawn, figures[i]); !judged) return judged;
  }
  return Done{};
}

}  // namespace

Result<Measured> measure(Engine& engine, const Group& group, int rounds) {
  if (const Result<const gl::Info*> info = engine.gl_info(); !info) return info.diagnostics();
  const Result<Map> map = engine.terrain(group.trials.front().scene);
  if (!map) return map.diagnostics();
  const Result<double> built = build_pyramid(engine, *map);
  if (!built) return built.diagnostics();
  Measured measured{.pyramid_seconds = *built};
  measured.figures.resize(group.trials.size());
  if (const auto judged = judge_round(engine, *map, group, measured.figures); !judged)
    return judged.diagnostics();
  std::vector<std::vector<double>> view_seconds(group.trials.size());
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < group.trials.size(); ++i) {
      const Result<Drawn> drawn = draw(engine, *map, group.trials[i].scene);
      if (!drawn) return drawn.diagnostics();
      measured.figures[i].seconds.push_back(drawn->seconds);
      view_seconds[i].push_back(drawn->view_seconds);
    }
  }
  for (std::size_t i = 0; i < group.trials.size(); ++i) {
    measured.figures[i].median = median(measured.figures[i].seconds);
    measured.figures[i].view_median = median(view_seconds[i]);
  }
  return measured;
}

}  // namespace gnomon::bench
