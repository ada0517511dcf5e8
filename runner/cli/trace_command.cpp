// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>

#include "cli/commands.h"
#include "engine.h"
#include "scene/discover.h"
#include "trace/trace.h"

namespace gnomon::cli {
namespace {

/// The ids of tests, a line each; of many the first.
std::string listing(const std::vector<scene::Scene>& tests) {
  constexpr std::size_t kMost = 20;
  std::string text;
  for (std::size_t i = 0; i < std::min(tests.size(), kMost); ++i) text += "\n  " + tests[i].id;
  if (tests.size() > kMost) text += "\n  and " + std::to_string(tests.size() - kMost) + " more";
  return text;
}

/// The one test that is meant.
Result<scene::Scene> choose(std::vector<scene::Scene> tests, const TraceArguments& arguments) {
  std::vector<scene::Scene> chosen;
  std::copy_if(tests.begin(), tests.end(), std::back_inserter(chosen),
               [&](const scene::Scene& test) { return scene::is_chosen(arguments.filters, test.id); });
  if (chosen.empty())
    return Diagnostic{.file = "--filter",
                      .message = "matches no test of the scene; it makes" + listing(tests)};
  if (chosen.size() > 1)
    return Diagnostic{.file = arguments.scene,
                      .message = "makes " + std::to_string(chosen.size()) +
                                 " tests; pick one with --filter:" + listing(chosen)};
  if (arguments.method) chosen[0].shadow.method = *arguments.method;
  return std::move(chosen[0]);
}

/// A failure that names no file is the scene's.
Diagnostics in_scene(Diagnostics diagnostics, const scene::Scene& scene) {
  for (Diagnostic& diagnostic : diagnostics)
    if (diagnostic.file.empty()) diagnostic.file = scene.file;
  return diagnostics;
}

Result<trace::Trace> trace_scene(const scene::Scene& scene, const TraceArguments& arguments) {
  Engine engine({.shader_library = {}, .includes = {}, .backend = Backend::kCpu});
  const Result<std::shared_ptr<const terrain::HeightMap>> map = engine.terrain(scene);
  if (!map) return map.diagnostics();
  if (Diagnostics wrong = scene::check_size(scene, (*map)->width, (*map)->height); !wrong.empty())
    return wrong;
  Result<trace::Trace> traced =
      trace::trace_pixel(scene, **map, {(*arguments.pixel)[0], (*arguments.pixel)[1]});
  if (!traced) return in_scene(traced.diagnostics(), scene);
  return traced;
}

bool overwrites_input(const std::string& output, const scene::Scene& scene) {
  const auto same = [&](const std::string& input) {
    std::error_code error;
    return std::filesystem::equivalent(output, input, error);
  };
  const auto* file = std::get_if<scene::FileTerrain>(&scene.terrain.source);
  const auto* points = std::get_if<scene::PointsCamera>(&scene.camera);
  return same(scene.file) || (file && same(file->path)) || (points && same(points->path));
}

}  // namespace

int run_command(const TraceArguments& arguments, Console& console) {
  scene::LoadResult loaded = scene::load_scene(arguments.scene, arguments.overrides, vocabulary());
  if (const int code = report(console, loaded.diagnostics); code != 0) return code;
  const Result<scene::Scene> scene = choose(std::move(loaded.tests), arguments);
  if (!scene) return report(console, scene.diagnostics());
  const std::string& json = arguments.json;
  if (!json.empty() && !is_stdout(json) && overwrites_input(json, *scene))
    return report(console, {{.file = json, .message = "is what is traced: write to another file"}});
  const Result<trace::Trace> traced = trace_scene(*scene, arguments);
  if (!traced) return report(console, traced.diagnostics());
  if (!json.empty()) {
    const Result<Done> written = write_text(console, json, trace::to_json(*traced, *scene));
    if (!written) return report(console, written.diagnostics());
  }
  for (const std::string& note : scene->notes) console.err << note << "\n";
  people(console, json) << trace::to_text(*traced, *scene);
  return traced->walk && !traced->walk->decided() ? static_cast<int>(Failure::kFailed) : 0;
}

}  // namespace gnomon::cli
