// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/experiments.h"
#include "cli/commands.h"
#include "judge/judge.h"
#include "scene/load.h"
#include "technique/technique.h"

namespace gnomon::cli {
namespace {

using bench::Figure;
using bench::Group;
using bench::Measured;
using bench::Trial;

std::string level_text(const scene::Shadow& shadow) {
  return shadow.q ? std::to_string(*shadow.q) : "auto";
}

bool has_cascades(const scene::Shadow& shadow) {
  return technique::find_technique(shadow.method)->bounds == technique::Bounds::kCascades;
}

const char* faces_text(scene::Cascades::Faces faces) {
  return faces == scene::Cascades::Faces::kAll     ? "all"
         : faces == scene::Cascades::Faces::kFront ? "front"
                                                   : "back";
}

/// The method, and what sets it apart in its group.
std::string label(const Trial& trial) {
  const scene::Shadow& shadow = trial.scene.shadow;
  if (!has_cascades(shadow)) return shadow.method + ", q " + level_text(shadow);
  const scene::Cascades& cascades = shadow.cascades;
  return fmt::format("cascades of {}, {}, bias {:g} {:g}, filter {}{}", cascades.size,
                     faces_text(cascades.faces), cascades.bias, cascades.slope_bias, cascades.filter,
                     cascades.stable ? ", stable" : "");
}

std::array<int, 2> viewport(const Trial& trial, const Figure& figure) {
  if (const auto* view = std::get_if<scene::ViewCamera>(&trial.scene.camera)) return view->size;
  const int side = static_cast<int>(std::lround(std::sqrt(figure.pixels)));
  return {side, side};
}

int map_side(const Trial& trial) {
  const auto* made = std::get_if<scene::ProceduralTerrain>(&trial.scene.terrain.source);
  return made ? made->width : 0;
}

nlohmann::json to_json(const Trial& trial, const Figure& figure, double pyramid_seconds) {
  const scene::Shadow& shadow = trial.scene.shadow;
  nlohmann::json row{{"map", trial.map},
                     {"viewport", viewport(trial, figure)},
                     {"azimuth", trial.scene.sun.azimuth},
                     {"elevation", trial.scene.sun.elevation},
                     {"method", shadow.method},
                     {"q", level_text(shadow)},
                     {"pixels", figure.pixels},
                     {"pyramid_seconds", pyramid_seconds},
                     {"view_median_seconds", figure.view_median},
                     {"median_seconds", figure.median},
                     {"seconds", figure.seconds},
                     {"mean_steps", figure.mean_steps},
                     {"changed", figure.changed}};
  if (map_side(trial) > 0) row["map_size"] = map_side(trial);
  if (has_cascades(shadow)) {
    row["cascade_size"] = shadow.cascades.size;
    row["faces"] = faces_text(shadow.cascades.faces);
    row["bias"] = shadow.cascades.bias;
    row["slope_bias"] = shadow.cascades.slope_bias;
    row["filter"] = shadow.cascades.filter;
    row["stable"] = shadow.cascades.stable;
  }
  if (figure.mismatches) {
    row["mismatches"] = *figure.mismatches;
    row["in_band"] = *figure.in_band;
  }
  return row;
}

/// Ratios are to the first method: absolute times say little on a shared machine.
std::string to_table(const Group& group, const Measured& measured) {
  const Trial& first = group.trials.front();
  const double base = measured.figures.front().median;
  const std::array<int, 2> size = viewport(first, measured.figures.front());
  std::string text = fmt::format(
      "{}{}, {} x {} pixels, sun {} high, view {:.1f} ms, pyramid {:.1f} ms (apart)\n", first.map,
      map_side(first) > 0 ? fmt::format(" {0} x {0}", map_side(first)) : "", size[0], size[1],
      first.scene.sun.elevation, 1e3 * measured.figures.front().view_median, 1e3 * measured.pyramid_seconds);
  text += fmt::format("  {:<46} {:>10} {:>8} {:>8} {:>10} {:>11} {:>8}\n", "method", "median ms", "ratio",
                      "steps", "changed %", "mismatches", "in band");
  for (std::size_t i = 0; i < group.trials.size(); ++i) {
    const Figure& figure = measured.figures[i];
    const auto counted = [](const std::optional<double>& n) { return n ? fmt::format("{}", *n) : "-"; };
    text += fmt::format("  {:<46} {:>10.1f} {:>7.2f}x {:>8.2f} {:>10.3f} {:>11} {:>8}\n",
                        label(group.trials[i]), 1e3 * figure.median, figure.median / base, figure.mean_steps,
                        100 * figure.changed / std::max(figure.pixels, 1.0), counted(figure.mismatches),
                        counted(figure.in_band));
  }
  return text;
}

/// Whether a method that is exact differs from the oracle.
bool has_fault(const Group& group, const Measured& measured) {
  for (std::size_t i = 0; i < group.trials.size(); ++i) {
    const auto* method = technique::find_technique(group.trials[i].scene.shadow.method);
    if (method->exact && measured.figures[i].mismatches.value_or(0) > 0) return true;
  }
  return false;
}

/// Of a trial's picture: what tells it from the others of its experiment.
std::string file_name(const Trial& trial, std::array<int, 2> viewport) {
  std::string text = fmt::format("{} {} {}x{} sun {:g} {}", trial.map, map_side(trial), viewport[0],
                                 viewport[1], trial.scene.sun.elevation, label(trial));
  std::erase(text, ',');
  std::replace(text.begin(), text.end(), ' ', '_');
  return text;
}

/// Hours of measuring are not to end in a folder that is not there.
Result<Done> prepare_outputs(const BenchArguments& arguments) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path parent = fs::path(arguments.json).parent_path();
  if (!parent.empty() && !fs::is_directory(parent, error))
    return Diagnostic{.file = arguments.json,
                      .message = "cannot be written: there is no folder " + parent.string(),
                      .failure = Failure::kMachine};
  if (!arguments.pictures.empty()) fs::create_directories(arguments.pictures, error);
  if (!arguments.pictures.empty() && !fs::is_directory(arguments.pictures, error))
    return Diagnostic{.file = arguments.pictures,
                      .message = "is no folder, and none can be made there: " + error.message(),
                      .failure = Failure::kMachine};
  return Done{};
}

/// The picture of each trial, and where its shadow differs from the first one's.
Result<Done> write_pictures(Engine& engine, const Group& group, const std::string& folder) {
  std::optional<Rendered> first;
  for (const Trial& trial : group.trials) {
    const Result<Rendered> rendered = engine.render(trial.scene);
    if (!rendered) return rendered.diagnostics();
    const std::string stem = folder + "/" + file_name(trial, {rendered->image.width, rendered->image.height});
    const Result<Done> written =
        image::write_png(stem + ".png", Engine::picture(*rendered, trial.scene, rendered->image));
    if (!written) return written;
    if (!first) {
      first = *rendered;
      continue;
    }
    const judge::CompareOptions options{.channels = {"b_shadow"}};
    const Result<Done> compared = image::write_png(
        stem + "_difference.png", judge::difference_picture(rendered->image, first->image, options));
    if (!compared) return compared;
  }
  return Done{};
}

/// The user's own map and camera, from a scene file of one test.
Result<Trial> own_trial(const std::string& file) {
  const scene::LoadResult loaded = scene::load_scene(file, {}, vocabulary());
  if (!loaded.diagnostics.empty()) return loaded.diagnostics;
  const scene::Scene& scene = loaded.tests.front();
  if (loaded.tests.size() != 1 || !std::get_if<scene::ViewCamera>(&scene.camera)) {
    return Diagnostic{.file = file,
                      .message = "expected a scene of one test with a perspective or orthographic camera"};
  }
  Trial trial{.map = scene.id.substr(scene.id.find_last_of('/') + 1), .scene = scene};
  trial.scene.shadow = {};
  return trial;
}

Result<Done> write_json(const BenchArguments& arguments, Engine& engine, nlohmann::json rows,
                        Console& console) {
  const Result<const gl::Info*> info = engine.gl_info();
  if (!info) return info.diagnostics();
  const std::string text = nlohmann::json{{"experiment", arguments.experiment},
                                          {"version", GNOMON_VERSION},
                                          {"backend", gl::name_of((*info)->device.api)},
                                          {"renderer", (*info)->renderer},
                                          {"rounds", arguments.rounds},
                                          {"rows", std::move(rows)}}
                               .dump(2) +
                           "\n";
  return write_text(console, arguments.json, text);
}

}  // namespace

int run_command(const BenchArguments& arguments, Console& console) {
  const bench::Experiment& experiment = *bench::find_experiment(arguments.experiment);
  Engine engine(
      {.shader_library = console.shader_library, .backend = arguments.backend, .device = arguments.device});
  if (const Result<Done> ready = prepare_outputs(arguments); !ready)
    return report(console, ready.diagnostics());
  bench::Options options{.sizes = arguments.sizes, .elevation = arguments.elevation};
  if (!arguments.scene.empty()) {
    Result<Trial> own = own_trial(arguments.scene);
    if (!own) return report(console, own.diagnostics());
    options.own = std::move(own).value();
  }
  nlohmann::json rows = nlohmann::json::array();
  int code = 0;
  std::size_t done = 0;
  const std::vector<Group> groups = experiment.groups(options);
  for (const Group& group : groups) {
    const Result<Measured> measured = bench::measure(engine, group, arguments.rounds, console.interrupted);
    if (!measured) {  // what was measured before is kept
      code = console.interrupted ? static_cast<int>(Failure::kInterrupted)
                                 : report(console, measured.diagnostics());
      if (console.interrupted)
        console.err << "interrupted: " << done << " of " << groups.size() << " tables were measured\n";
      break;
    }
    ++done;
    people(console, arguments.json) << to_table(group, *measured) << std::flush;
    for (std::size_t i = 0; i < group.trials.size(); ++i)
      rows.push_back(to_json(group.trials[i], measured->figures[i], measured->pyramid_seconds));
    if (has_fault(group, *measured)) code = 1;
    if (arguments.pictures.empty()) continue;
    const Result<Done> written = write_pictures(engine, group, arguments.pictures);
    if (!written) code = worse(code, report(console, written.diagnostics()));
  }
  if (arguments.json.empty() || rows.empty()) return code;
  const Result<Done> written = write_json(arguments, engine, std::move(rows), console);
  if (code > 1 && written)
    console.err << (is_stdout(arguments.json) ? "standard output" : arguments.json)
                << ": holds what was measured before\n";
  return written ? code : worse(code, report(console, written.diagnostics()));
}

}  // namespace gnomon::cli
