// SPDX-License-Identifier: MIT
#include "bench/experiments.h"

#include <algorithm>
#include <array>

#include "technique/technique.h"
#include "terrain/procedural.h"

namespace gnomon::bench {
namespace {

using scene::Scene;

constexpr double kSpacing = 10;  // metres

Trial over(const std::string& kind, int size) {
  Scene scene;
  scene.file = scene.id = "bench";
  scene.terrain.source =
      scene::ProceduralTerrain{.kind = kind, .width = size, .height = size, .seed = 1, .parameters = {}};
  scene.terrain.spacing = {{kSpacing, kSpacing}};
  return {kind, scene};
}

std::vector<int> sizes(const Options& options, std::vector<int> own) {
  return options.sizes.empty() ? own : options.sizes;
}

/// Looks over the map from its southern edge, so that ground fills the picture from near to far.
scene::ViewCamera across(double side, std::array<int, 2> viewport) {
  return {.eye = {0.5 * side, -0.02 * side, 0.3 * side},
          .target = {0.52 * side, 0.5 * side, 0},
          .extent = 45,
          .size = viewport};
}

/// Highest sample of a procedural map, metres.
double highest(const scene::ProceduralTerrain& made) {
  const Result<terrain::HeightMap> map = terrain::make_procedural({.kind = made.kind,
                                                                   .width = made.width,
                                                                   .height = made.height,
                                                                   .seed = made.seed,
                                                                   .spacing_x = kSpacing,
                                                                   .spacing_y = kSpacing,
                                                                   .parameters = made.parameters});
  if (!map) return 0;  // said when the trial is drawn
  return double{*std::max_element(map->samples.begin(), map->samples.end())};
}

/// From just above the highest ground, over a corner of the map, to its far end: near slopes below, and a
/// background many times as far away.
scene::ViewCamera along(const scene::ProceduralTerrain& made, std::array<int, 2> viewport) {
  const double side = made.width * kSpacing;
  const double eye = highest(made) + 5 * kSpacing;
  return {.eye = {0.03 * side, 0.03 * side, eye},
          .target = {0.5 * side, 0.5 * side, 0.55 * eye},
          .extent = 40,
          .size = viewport};
}

/// The maps that experiments on levels look over.
std::vector<Trial> maps(const Options& options) {
  std::vector<Trial> all;
  for (const int size : sizes(options, {4096})) {
    for (const char* kind : {"fractal", "gorge"}) {
      all.push_back(over(kind, size));
      all.back().scene.camera = across(size * kSpacing, {1920, 1080});
    }
  }
  if (options.own) all.push_back(*options.own);
  return all;
}

Trial with(Trial trial, const std::string& method, std::optional<int> q, double elevation) {
  trial.scene.shadow.method = method;
  trial.scene.shadow.q = q;
  trial.scene.sun.elevation = elevation;
  return trial;
}

/// Levels 0 to 4 and "auto" of one picture.
Group levels_of(const Trial& trial, double elevation) {
  Group group{.trials = {}, .judged = false};
  for (const int q : {0, 1, 2, 3, 4}) group.trials.push_back(with(trial, "multilevel", q, elevation));
  group.trials.push_back(with(trial, "multilevel", std::nullopt, elevation));
  return group;
}

std::vector<Group> methods(const Options& options) {
  std::vector<Group> groups;
  for (const int size : sizes(options, {1024, 2048})) {
    Group group;
    for (const technique::Technique& technique : technique::techniques()) {
      if (technique.program.empty()) continue;
      group.trials.push_back(with(over("fractal", size), technique.name, 0, options.elevation.value_or(10)));
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// Figure 8 of the 2022 paper: frame rate by level and height of the sun.
std::vector<Group> levels(const Options& options) {
  std::vector<double> elevations{2, 10, 30, 60};
  if (options.elevation) elevations = {*options.elevation};
  std::vector<Group> groups;
  for (const Trial& map : maps(options))
    for (const double elevation : elevations) groups.push_back(levels_of(map, elevation));
  return groups;
}

std::vector<Group> viewports(const Options& options) {
  constexpr std::array<std::array<int, 2>, 5> kViewports{
      {{128, 128}, {256, 256}, {512, 512}, {1024, 1024}, {1920, 1080}}};
  std::vector<Group> groups;
  for (Trial map : maps(options)) {
    for (const auto& viewport : kViewports) {
      std::get<scene::ViewCamera>(map.scene.camera).size = viewport;
      groups.push_back(levels_of(map, options.elevation.value_or(10)));
    }
  }
  return groups;
}

Trial cascaded(Trial trial, int size, const scene::Cascades& cascades) {
  trial.scene.shadow.method = "cascaded_shadow_maps";
  trial.scene.shadow.cascades = cascades;
  trial.scene.shadow.cascades.size = size;
  return trial;
}

/// The least wrong of `biases` on the maps of `cascades`: docs/experiments.md.
scene::Cascades best() {
  return {.bias = 0.5, .slope_bias = 0.5, .filter = 1, .stable = false};
}

/// Table 1 of the 2021 paper: both methods on maps of three sizes.
std::vector<Group> map_sizes(const Options& options) {
  std::vector<Group> groups;
  for (const int size : sizes(options, {1024, 2048, 4096})) {
    Trial trial = over("fractal", size);
    trial.scene.camera = across(size * kSpacing, {1920, 1080});
    trial = with(trial, "multilevel", 0, options.elevation.value_or(20));
    groups.push_back(
        {.trials = {trial, cascaded(trial, 2048, best()), cascaded(trial, 4096, best())}, .judged = false});
  }
  return groups;
}

/// The stress maps of both papers, and a view whose background lies far away.
std::vector<Trial> stress(const Options& options) {
  constexpr std::array<int, 2> kViewport{960, 540};
  std::vector<Trial> all;
  for (const int size : sizes(options, {1024})) {
    const double side = size * kSpacing;
    for (const char* kind : {"spikes", "steps", "gorge", "fractal"}) {
      Trial trial = over(kind, size);
      trial.scene.camera = across(side, kViewport);
      trial.scene.sun.elevation = options.elevation.value_or(10);
      auto& made = std::get<scene::ProceduralTerrain>(trial.scene.terrain.source);
      if (trial.map == "steps") {
        // An open staircase: the sun behind its highest step, where the model has no wall.
        made.parameters = {{"rise", 0.04 * side / 8}};
        trial.scene.sun = {.azimuth = 262, .elevation = options.elevation.value_or(2)};
      }
      if (trial.map == "fractal") {
        trial.map = "far background";
        trial.scene.camera = along(made, kViewport);
      }
      all.push_back(std::move(trial));
    }
  }
  if (options.own) {
    all.push_back(*options.own);
    scene::Sun& sun = all.back().scene.sun;
    sun.elevation = options.elevation.value_or(sun.elevation);
  }
  return all;
}

std::vector<Group> cascades(const Options& options) {
  std::vector<Group> groups;
  for (const Trial& trial : stress(options)) {
    Group group{.trials = {trial}};
    for (const int maps : {512, 1024, 2048, 4096}) group.trials.push_back(cascaded(trial, maps, best()));
    if (trial.map == "steps") {
      group.trials.push_back(group.trials.back());
      group.trials.back().scene.shadow.cascades.faces = scene::Cascades::Faces::kFront;
    }
    groups.push_back(std::move(group));
  }
  return groups;
}

/// What bias, filter and fit make cascades least wrong.
std::vector<Group> biases(const Options& options) {
  std::vector<Group> groups;
  for (const Trial& trial : stress(options)) {
    Group group{.trials = {trial}};
    for (const int filter : {1, 3})
      for (const double bias : {0.0, 0.5, 1.0})
        for (const double slope : {0.0, 0.5, 1.0})
          group.trials.push_back(
              cascaded(trial, 2048, {.bias = bias, .slope_bias = slope, .filter = filter, .stable = false}));
    group.trials.push_back(cascaded(trial, 2048, {}));
    groups.push_back(std::move(group));
  }
  return groups;
}

}  // namespace

const std::vector<Experiment>& experiments() {
  static const std::vector<Experiment> table = {
      {"methods", "every method on a fractal map, a ray a sample, judged by the oracle", methods},
      {"levels", "time and changed pixels by level of detail and height of the sun (figure 8, 2022)", levels,
       true},
      {"viewports", "the same by size of the picture", viewports, true},
      {"map_sizes", "ray casting and cascaded shadow maps by size of the map (table 1, 2021)", map_sizes},
      {"cascades", "wrong pixels of cascaded shadow maps on the papers' stress maps, by their size", cascades,
       true},
      {"biases", "the same by bias and filter, to choose them", biases, true},
  };
  return table;
}

const Experiment* find_experiment(const std::string& name) {
  const auto& table = experiments();
  const auto it =
      std::find_if(table.begin(), table.end(), [&](const Experiment& e) { return e.name == name; });
  return it == table.end() ? nullptr : &*it;
}

}  // namespace gnomon::bench
