// SPDX-License-Identifier: MIT
#include "bench/measure.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <numeric>

#include "judge/judge.h"
#include "technique/renderer.h"

namespace gnomon::bench {
namespace {

using Map = std::shared_ptr<const terrain::HeightMap>;

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
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

struct View {
  technique::Ground ground;
  double seconds = 0;
};

struct Drawn {
  View view;
  image::Image image;
  double seconds = 0;
};

Result<View> view_of(Engine& engine, const Map& map, const scene::Scene& scene) {
  if (const auto* camera = std::get_if<scene::MapCamera>(&scene.camera))
    return View{technique::map_ground(*camera, scene.shadow, *map)};
  const Result<const technique::Pyramid*> base = engine.pyramid(map, 0);
  if (!base) return base.diagnostics();
  double seconds = 0;
  Result<technique::Ground> seen = technique::seen_ground(
      engine.programs(), **base, std::get<scene::ViewCamera>(scene.camera), scene.shadow, {}, &seconds);
  if (!seen) return seen.diagnostics();
  return View{std::move(seen).value(), seconds};
}

/// Trials of a group share the camera: a fixed level asks the points of another one.
Result<View> view_after(Engine& engine, const Map& map, const scene::Scene& scene, const View* first) {
  if (!first || !scene.shadow.q) return view_of(engine, map, scene);
  View view = *first;
  std::fill(view.ground.q.begin(), view.ground.q.end(), static_cast<float>(*scene.shadow.q));
  return view;
}

Result<Drawn> draw(Engine& engine, const Map& map, const scene::Scene& scene, const View* first) {
  Result<View> view = view_after(engine, map, scene, first);
  if (!view) return view.diagnostics();
  technique::leave_out_holes(view->ground, *map);
  const Result<technique::Pyramids> pyramids =
      engine.pyramids(map, view->ground.levels(), scene.shadow.method);
  if (!pyramids) return pyramids.diagnostics();
  double seconds = 0;
  Result<image::Image> image =
      technique::render_shadow(engine.programs(), *pyramids, scene, view->ground, &seconds);
  if (!image) return image.diagnostics();
  return Drawn{std::move(view).value(), std::move(image).value(), seconds};
}

/// Where a group is drawn.
struct Bench {
  Engine& engine;
  const Group& group;
  const std::atomic<bool>& interrupted;
  Map map;
};

/// Draws every trial once, in turn, and hands each to `take(index, drawn)`.
template <class Take>
Result<Done> draw_round(const Bench& bench, Take take) {
  std::optional<View> first;
  for (std::size_t i = 0; i < bench.group.trials.size(); ++i) {
    if (bench.interrupted) return Diagnostic{.message = "interrupted", .failure = Failure::kInterrupted};
    Result<Drawn> drawn =
        draw(bench.engine, bench.map, bench.group.trials[i].scene, first ? &*first : nullptr);
    if (!drawn) return drawn.diagnostics();
    if (const Result<Done> taken = take(i, *drawn); !taken) return taken;
    if (i == 0) first = std::move(drawn->view);
  }
  return Done{};
}

Result<Done> judge_figure(Engine& engine, const Trial& trial, const Drawn& drawn, Figure& figure) {
  const Result<image::Image> reference = engine.reference(trial.scene, drawn.view.ground);
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
Result<Done> judge_round(const Bench& bench, std::vector<Figure>& figures) {
  std::vector<float> first;
  return draw_round(bench, [&](std::size_t i, const Drawn& drawn) -> Result<Done> {
    if (i == 0) first = drawn.image.channels.at("b_shadow");
    count(drawn, first, figures[i]);
    if (!bench.group.judged) return Done{};
    return judge_figure(bench.engine, bench.group.trials[i], drawn, figures[i]);
  });
}

/// Draws of a few milliseconds depend on how the system happens to spread their threads: they need more
/// rounds.
bool enough(const std::vector<Figure>& figures, std::size_t rounds) {
  constexpr std::size_t kMost = 50;
  constexpr double kLong = 0.25;  // seconds
  const std::size_t drawn = figures.front().seconds.size();
  double seconds = 0;
  for (const Figure& figure : figures)
    seconds = std::accumulate(figure.seconds.begin(), figure.seconds.end(), seconds);
  return drawn >= rounds && (drawn >= kMost || seconds >= kLong);
}

}  // namespace

Result<Measured> measure(Engine& engine, const Group& group, int rounds,
                         const std::atomic<bool>& interrupted) {
  if (const Result<const gl::Info*> info = engine.gl_info(); !info) return info.diagnostics();
  const Result<Map> map = engine.terrain(group.trials.front().scene);
  if (!map) return map.diagnostics();
  const Result<double> built = build_pyramid(engine, *map);
  if (!built) return built.diagnostics();
  Measured measured{.pyramid_seconds = *built};
  measured.figures.resize(group.trials.size());
  const Bench bench{engine, group, interrupted, *map};
  if (const auto judged = judge_round(bench, measured.figures); !judged) return judged.diagnostics();
  std::vector<std::vector<double>> views(group.trials.size());
  while (!enough(measured.figures, static_cast<std::size_t>(rounds))) {
    const Result<Done> drawn = draw_round(bench, [&](std::size_t i, const Drawn& trial) -> Result<Done> {
      measured.figures[i].seconds.push_back(trial.seconds);
      views[i].push_back(trial.view.seconds);
      return Done{};
    });
    if (!drawn) return drawn.diagnostics();
  }
  for (std::size_t i = 0; i < group.trials.size(); ++i) {
    measured.figures[i].median = median(measured.figures[i].seconds);
    measured.figures[i].view_median = median(views[i]);
  }
  return measured;
}

}  // namespace gnomon::bench
