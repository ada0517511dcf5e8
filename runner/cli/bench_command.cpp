// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <span>

#include "bench.h"
#include "cli/commands.h"
#include "gnomon/atomic_file.h"

namespace gnomon::cli {
namespace {

nlohmann::json to_json(const BenchResult& result) {
  nlohmann::json methods = nlohmann::json::array();
  for (const BenchFigure& figure : result.figures) {
    methods.push_back({{"method", figure.method},
                       {"median_seconds", figure.median},
                       {"seconds", figure.seconds},
                       {"mean_steps", figure.mean_steps},
                       {"mismatches", figure.mismatches},
                       {"in_band", figure.in_band}});
  }
  return {{"map", "fractal"},
          {"size", result.options.size},
          {"azimuth", result.options.azimuth},
          {"elevation", result.options.elevation},
          {"rays", result.rays},
          {"pyramid_seconds", result.pyramid_seconds},
          {"methods", methods}};
}

/// Ratios are to the slowest method: absolute times say little on a shared machine.
std::string to_table(const BenchResult& result) {
  double slowest = 0;
  for (const BenchFigure& figure : result.figures) slowest = std::max(slowest, figure.median);
  std::string text =
      fmt::format("fractal {0} x {0}, sun {1}, {2} degrees, {3} rays a round, pyramid {4:.1f} ms (apart)\n",
                  result.options.size, result.options.azimuth, result.options.elevation, result.rays,
                  1e3 * result.pyramid_seconds);
  text += fmt::format("  {:<20} {:>12} {:>8} {:>12} {:>12} {:>8}\n", "method", "median ms", "ratio",
                      "steps a ray", "mismatches", "in band");
  for (const BenchFigure& figure : result.figures) {
    text += fmt::format("  {:<20} {:>12.1f} {:>7.2f}x {:>12.2f} {:>12} {:>8}\n", figure.method,
                        1e3 * figure.median, slowest / figure.median, figure.mean_steps, figure.mismatches,
                        figure.in_band);
  }
  return text;
}

}  // namespace

int run_command(const BenchArguments& arguments, Console& console) {
  Engine engine(
      {.shader_library = console.shader_library, .backend = arguments.backend, .device = arguments.device});
  nlohmann::json all = nlohmann::json::array();
  int code = 0;
  for (const int size : arguments.sizes) {
    if (console.interrupted) return static_cast<int>(Failure::kInterrupted);
    const Result<BenchResult> result =
        bench(engine, {.size = size, .elevation = arguments.elevation, .rounds = arguments.rounds});
    if (!result) return report(console, result.diagnostics());
    console.out << to_table(*result) << std::flush;
    all.push_back(to_json(*result));
    for (const BenchFigure& figure : result->figures) code = figure.mismatches > 0 ? 1 : code;
  }
  if (arguments.json.empty()) return code;
  const Result<const gl::Info*> info = engine.gl_info();
  const std::string text = nlohmann::json{{"version", GNOMON_VERSION},
                                          {"backend", gl::name_of((*info)->device.api)},
                                          {"renderer", (*info)->renderer},
                                          {"runs", all}}
                               .dump(2) +
                           "\n";
  const Result<Done> written = write_file_atomically(arguments.json, std::as_bytes(std::span(text)));
  return written ? code : worse(code, report(console, written.diagnostics()));
}

}  // namespace gnomon::cli
