// SPDX-License-Identifier: MIT
#include "cli/arguments.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>

#include "bench/experiments.h"
#include "cli/choices.h"
#include "cli/texts.h"
#include "gnomon/compiler/compiler.h"
#include "technique/technique.h"
#include "trace/trace.h"

namespace gnomon::cli {
namespace {

/// An option whose text is one of the keys of `table`.
template <class Value>
CLI::Option* add_choice(CLI::App* app, const std::string& name, Value& value,
                        const std::map<std::string, Value>& table, const std::string& description) {
  return app
      ->add_option_function<std::string>(
          name,
          [&value, &table, name](const std::string& text) {
            const auto it = table.find(text);
            if (it == table.end())
              throw CLI::ValidationError(name, "'" + text + "' is not one of " + keys_of(table));
            value = it->second;
          },
          description)
      ->type_name("NAME");
}

template <class Number>
Number number_of(const std::string& text, const std::string& name, const std::string& shape) {
  const std::optional<Number> number = number_in<Number>(text);
  if (!number) throw CLI::ValidationError(name, "'" + text + "' is not " + shape);
  return *number;
}

/// Two numbers with `separator` between them; where `one_is_both`, one number stands for both.
template <class Number>
CLI::Option* add_pair(CLI::App* app, const std::string& name, std::optional<std::array<Number, 2>>& pair,
                      char separator, bool one_is_both, const std::string& shape,
                      const std::string& description) {
  return app
      ->add_option_function<std::string>(
          name,
          [&pair, name, shape, separator, one_is_both](const std::string& text) {
            const std::size_t at = text.find(separator);
            if (at == std::string::npos && !one_is_both)
              throw CLI::ValidationError(name, "'" + text + "' is not " + shape);
            const std::string second = at == std::string::npos ? text : text.substr(at + 1);
            pair = {number_of<Number>(text.substr(0, at), name, shape),
                    number_of<Number>(second, name, shape)};
          },
          description)
      ->type_name(shape);
}

/// A finite number of lowest..highest; CLI::Range lets NaN through.
void add_number(CLI::App* app, const std::string& name, const std::string& unit, double lowest,
                double highest, const std::function<void(double)>& store, const std::string& description) {
  std::ostringstream shape;
  shape << "a number from " << lowest << " to " << highest;
  app->add_option_function<std::string>(
         name,
         [=, shape = shape.str()](const std::string& text) {
           const auto number = number_of<double>(text, name, shape);
           if (number < lowest || number > highest)
             throw CLI::ValidationError(name, "'" + text + "' is not " + shape);
           store(number);
         },
         description)
      ->type_name(unit);
}

void add_overrides(CLI::App* app, std::vector<std::string>& overrides) {
  app->add_option("--set", overrides,
                  "override a scene key by its dotted path, such as sun.elevation=5 (repeatable)")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

void add_device(CLI::App* app, std::string& device) {
  app->add_option("--device", device,
                  "which of the devices of 'gnomon info', by number or a part of its name. Default: the back "
                  "end's first that works")
      ->type_name("N|NAME");
}

const std::string kGlBackendsText = "auto: hardware by EGL, else software by EGL, else OSMesa; egl; osmesa";

void add_backend(CLI::App* app, Backend& backend, std::string& device) {
  add_choice(app, "--backend", backend, kBackends,
             kGlBackendsText + "; cpu: the oracle, no OpenGL. Default auto");
  add_device(app, device);
}

/// For a command that draws and does nothing else: the oracle is no back end of it.
void add_gl_backend(CLI::App* app, Backend& backend, std::string& device) {
  add_choice(app, "--backend", backend, kGlBackends, kGlBackendsText + ". Default auto")
      ->check([](const std::string& text) {
        return text == "cpu" ? "bench times OpenGL methods, which 'cpu' has none of; expected one of " +
                                   keys_of(kGlBackends)
                             : std::string();
      });
  add_device(app, device);
}

/// --device picks an OpenGL device, --backend cpu has none.
void check_device(Backend backend, const std::string& device) {
  if (backend == Backend::kCpu && !device.empty())
    throw CLI::ValidationError("--device",
                               "picks an OpenGL device; '--backend cpu' uses none: leave one out");
}

void add_target(CLI::App* app, std::string& target) {
  std::vector<std::string> names;
  for (const compiler::Target& t : compiler::targets()) {
    if (t.format == compiler::Format::kGlsl) names.push_back(t.name);
  }
  app->add_option("--target", target, "dialect that the modules are assembled in. Default glsl450")
      ->type_name("DIALECT")
      ->check(CLI::IsMember(names));
}

std::string method_names() {
  std::string names;
  for (const technique::Technique& t : technique::techniques()) names += (names.empty() ? "" : ", ") + t.name;
  return names;
}

void check_method(const std::string& name) {
  if (!technique::find_technique(name)) {
    throw CLI::ValidationError("--method", "'" + name + "' is not one of " + method_names());
  }
}

terrain::RawLayout raw_layout_of(const std::string& text) {
  const Result<terrain::RawLayout> layout = raw_layout_in(text);
  if (!layout) throw CLI::ValidationError("--raw", layout.diagnostics().front().message);
  return *layout;
}

void add_map_options(CLI::App* app, RenderArguments& a) {
  add_pair<double>(app, "--sun", a.sun, ',', false, "AZIMUTH,ELEVATION",
                   "degrees clockwise from grid north, degrees above the horizon. Default 315,45");
  app->add_option_function<std::string>(
         "--time",
         [&a](const std::string& text) {
           const Result<ephemeris::Utc> time = ephemeris::parse_utc(text);
           if (!time) throw CLI::ValidationError("--time", time.diagnostics().front().message);
           a.time = *time;
         },
         "where the sun stands at this time, such as 2024-06-21T12:00:00Z; geometric, without refraction")
      ->type_name("UTC");
  add_pair<double>(
      app, "--at", a.at, ',', false, "LAT,LON",
      "of --time: where the map lies, degrees north and degrees east. Default: the middle of the map, where "
      "its georeference says");
  app->add_option_function<std::string>(
         "--method",
         [&a](const std::string& name) {
           check_method(name);
           a.method = name;
         },
         "shadow method: " + method_names() + ". Default multilevel")
      ->type_name("NAME");
  app->add_option("--q", a.q, "level of detail, 0 is the map itself. Default 0")
      ->type_name("N")
      ->check(CLI::Range(0, 30));
  add_number(
      app, "--receiver-height", "METRES", 0, 1e9, [&a](double v) { a.receiver_height = v; },
      "metres above the surface of the level. Default 0");
  add_pair<int>(app, "--size", a.size, 'x', false, "WxH", "pixels. Default: one a height sample");
  add_pair<double>(app, "--spacing", a.spacing, ',', true, "X[,Y]",
                   "metres between height samples. Default: by the file's georeference, else 1");
  add_number(
      app, "--vertical-scale", "S", -1e9, 1e9, [&a](double v) { a.vertical_scale = v; },
      "metres per stored unit. Default: the file's unit, else 1");
  app->add_option("--channel", a.channel, "channel of an image that has several")->type_name("NAME");
  app->add_option_function<std::string>(
         "--raw", [&a](const std::string& text) { a.raw = raw_layout_of(text); },
         "FILE is bare numbers, the north row first: uint8, int8, uint16, int16, uint32, int32, float32 or "
         "float64; "
         "little by default")
      ->type_name("WxH,TYPE[,little|big][,skip=BYTES]");
  add_number(
      app, "--nodata", "V", -std::numeric_limits<double>::max(), std::numeric_limits<double>::max(),
      [&a](double v) { a.nodata = v; },
      "stored number that means \"no data here\", beside the file's own and NaN");
}

void add_render(CLI::App& root, RenderArguments& a) {
  CLI::App* app = root.add_subcommand("render",
                                      "Render the shadow of a scene or of a height map. A matrix, cameras "
                                      "and frames make an image each, named by what "
                                      "tells it apart; frames also an animated preview (.gif)");
  auto* scene = app->add_option("SCENE", a.scene, "scene file (JSON)");
  auto* heightmap =
      app->add_option("--heightmap", a.heightmap,
                      "heights: PNG, EXR, TIFF, .hgt, ESRI ASCII grid, USGS DEM, or bare numbers with --raw")
          ->type_name("FILE");
  scene->excludes(heightmap);
  add_map_options(app, a);
  add_overrides(app, a.overrides);
  add_backend(app, a.backend, a.device);
  add_target(app, a.target);
  app->add_option("-o", a.output, "what to write: .exr all channels, .png a picture, .tif b_shadow")
      ->type_name("OUT")
      ->required();
  app->footer("--sun to --nodata go with --heightmap, --set with SCENE.");
}

void add_test_options(CLI::App* app, TestArguments& a) {
  app->add_option("PATH", a.paths, "scene files or folders. Default: the project's scenes");
  app->add_option("--filter", a.filters,
                  "only tests whose id matches; * crosses /, a leading ! excludes (repeatable)")
      ->type_name("GLOB")
      ->allow_extra_args(false);
  app->add_option("--jobs", a.jobs, "worker processes. Default: one a core")
      ->type_name("N")
      ->check(CLI::Range(1, 1024));
  app->add_option("--shard", a.shard, "run every N-th test, beginning with the I-th (from 1)")
      ->type_name("I/N");
  add_backend(app, a.backend, a.device);
  add_target(app, a.target);
  app->add_option("--report", a.report, "write a page (DIR/index.html) with every test's pictures")
      ->type_name("DIR");
  add_choice(app, "--update-goldens", a.update, kUpdates,
             "none: a missing golden fails; missing: absent ones are written; changed: differing ones too; "
             "all: every "
             "one. Default none");
  app->add_flag("--list", a.list, "print the ids and run nothing");
  add_number(
      app, "--timeout", "SECONDS", 0.1, 86400, [&a](double v) { a.timeout = v; },
      "a test without an answer for so long fails. Default 120");
  add_overrides(app, a.overrides);
}

void add_diff(CLI::App& root, DiffArguments& a) {
  CLI::App* app = root.add_subcommand("diff", "Compare two images channel by channel");
  app->add_option("ACTUAL", a.actual, "image to judge")->required();
  app->add_option("EXPECTED", a.expected, "image to hold it against; its channel 'band' masks pixels")
      ->required();
  app->add_option("-o", a.output, "picture of the difference")->type_name("DIFF.png");
  app->add_option("--channel", a.channels, "compare this channel only (repeatable)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  app->add_option("--tolerance", a.tolerances,
                  "absolute difference that passes, for one channel or for all (repeatable)")
      ->type_name("[CHANNEL=]ABS")
      ->allow_extra_args(false);
  add_number(
      app, "--max-mismatch", "FRACTION", 0, 1, [&a](double v) { a.max_mismatch = v; },
      "share of pixels that may differ. Default 0");
}

void add_trace(CLI::App& root, TraceArguments& a) {
  CLI::App* app = root.add_subcommand("trace", "Print every step of a pixel's shadow ray, with the reason");
  app->add_option("SCENE", a.scene, "scene file (JSON)")->required();
  add_pair<int>(app, "--pixel", a.pixel, ',', false, "X,Y",
                "column and row, counted from 0 at the image's upper left corner")
      ->required();
  app->add_option("--filter", a.filters,
                  "which test of a scene that makes several, by its id; * crosses /, a leading ! excludes "
                  "(repeatable)")
      ->type_name("GLOB")
      ->allow_extra_args(false);
  std::string names;
  for (const std::string& name : trace::traceable_methods()) names += (names.empty() ? "" : ", ") + name;
  app->add_option_function<std::string>(
         "--method",
         [&a, names](const std::string& name) {
           check_method(name);
           const auto& known = trace::traceable_methods();
           if (std::find(known.begin(), known.end(), name) == known.end())
             throw CLI::ValidationError(
                 "--method", "'" + name + "' has no steps that could be told; expected one of " + names);
           a.method = name;
         },
         "follow this method instead of the scene's: " + names)
      ->type_name("NAME");
  add_overrides(app, a.overrides);
  app->add_option("--json", a.json,
                  "also write the steps as JSON; - is standard output, and the text goes to standard error")
      ->type_name("FILE");
}

void add_small_commands(CLI::App& root, ValidateArguments& validate, NewArguments& made,
                        BenchArguments& timed) {
  CLI::App* app = root.add_subcommand("validate", "Check scene files: every error at once, FILE:LINE:COLUMN");
  app->add_option("SCENE", validate.scenes, "scene files or folders")->required();
  add_overrides(app, validate.overrides);

  app = root.add_subcommand("new", "Write a described scene that passes, ready to edit");
  app->add_option("NAME", made.name, "where below the project's scenes, such as ridges/morning")->required();

  app = root.add_subcommand("bench", "Time the methods side by side on the same work, in one run");
  std::vector<std::string> names;
  std::string with_own;
  for (const bench::Experiment& experiment : bench::experiments()) {
    names.push_back(experiment.name);
    if (experiment.takes_own) with_own += (with_own.empty() ? "" : ", ") + experiment.name;
  }
  app->add_option("--experiment", timed.experiment, "what is measured. Default methods")
      ->type_name("NAME")
      ->check(CLI::IsMember(names));
  app->add_option("--size", timed.sizes,
                  "samples a side of procedural maps (repeatable). Default: the experiment's own")
      ->type_name("N")
      ->check(CLI::Range(16, 16384));
  add_number(
      app, "--elevation", "DEGREES", 0.1, 89.9, [&timed](double v) { timed.elevation = v; },
      "of the sun, degrees. Default: the experiment's own");
  app->add_option("--rounds", timed.rounds,
                  "how often each image is drawn at least; quick ones oftener. Default 5")
      ->type_name("N")
      ->check(CLI::Range(1, 1000));
  app->add_option(
         "--scene", timed.scene,
         "also look at this scene's map through its camera, perspective or orthographic (" + with_own + ")")
      ->type_name("FILE");
  app->add_option("--pictures", timed.pictures, "also write each image, and where it differs from the first")
      ->type_name("FOLDER");
  add_gl_backend(app, timed.backend, timed.device);
  app->add_option("--json", timed.json,
                  "also write the figures as JSON; - is standard output, and the tables go to standard error")
      ->type_name("FILE");

  root.add_subcommand("info",
                      "Print back ends, devices, renderer, GL version, limits, versions of everything");
}

/// Scene keys that the options of a height map would contradict.
void check_render(const RenderArguments& a) {
  if (a.scene.empty() == a.heightmap.empty())
    throw CLI::ValidationError("render", "needs a SCENE.json or --heightmap FILE");
  const bool map_option = a.sun || a.time || a.at || a.method || a.q || a.receiver_height || a.size ||
                          a.spacing || a.vertical_scale || a.channel || a.raw || a.nodata;
  if (!a.scene.empty() && map_option) {
    throw CLI::ValidationError("render",
                               "--sun, --method, --q and the like go with --heightmap; a scene takes --set, "
                               "such as --set sun.elevation=10");
  }
  if (!a.heightmap.empty() && !a.overrides.empty()) {
    throw CLI::ValidationError(
        "render", "--set goes with a scene; a height map takes --sun, --method, --q and the like");
  }
  if (a.sun && a.time)
    throw CLI::ValidationError("render", "--sun and --time both say where the sun stands: leave one out");
  if (a.at && !a.time)
    throw CLI::ValidationError("--at",
                               "says where the map lies at a --time, such as --time 2024-06-21T12:00:00Z");
}

std::string commands_of(const CLI::App& root) {
  std::string text = "The commands:";
  for (const CLI::App* command :
       root.get_subcommands([](const CLI::App* app) { return !app->get_group().empty(); })) {
    text += " " + command->get_name();
  }
  return text + "\n";
}

}  // namespace

CommandLine parse_arguments(int argc, const char* const* argv) {
  CLI::App root("gnomon - renders terrain shadows from scene files and holds them against golden images",
                "gnomon");
  root.set_version_flag("--version", "gnomon " GNOMON_VERSION);
  root.require_subcommand(1);
  RenderArguments render;
  TestArguments test;
  DiffArguments diff;
  ValidateArguments validate;
  NewArguments made;
  BenchArguments bench;
  TraceArguments trace;
  add_render(root, render);
  add_test_options(root.add_subcommand("test", "Run scenes as tests"), test);
  add_test_options(root.add_subcommand("worker", "")->group(""), test);
  add_diff(root, diff);
  add_trace(root, trace);
  add_small_commands(root, validate, made, bench);
  try {
    root.parse(argc, argv);
    if (root.got_subcommand("render")) check_render(render);
    check_device(render.backend, render.device);
    check_device(test.backend, test.device);
    if (!bench.scene.empty() && !bench::find_experiment(bench.experiment)->takes_own)
      throw CLI::ValidationError("--scene", "the experiment '" + bench.experiment + "' has no map to add to");
  } catch (const CLI::ParseError& error) {
    std::ostringstream out;
    std::ostringstream err;
    const bool asked = root.exit(error, out, err) == 0;
    if (root.get_subcommands().empty() && !asked) err << commands_of(root);
    return {std::nullopt, asked ? out.str() : err.str(), asked ? 0 : 2};
  }
  test.worker = root.got_subcommand("worker");
  const std::string name = root.get_subcommands().front()->get_name();
  if (name == "render") return {render, {}, 0};
  if (name == "diff") return {diff, {}, 0};
  if (name == "validate") return {validate, {}, 0};
  if (name == "new") return {made, {}, 0};
  if (name == "bench") return {bench, {}, 0};
  if (name == "trace") return {trace, {}, 0};
  if (name == "info") return {InfoArguments{}, {}, 0};
  return {test, {}, 0};
}

}  // namespace gnomon::cli
