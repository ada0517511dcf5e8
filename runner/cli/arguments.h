// SPDX-License-Identifier: MIT
// What a person typed after `gnomon`. docs/cli.md describes it; a test holds that page against --help.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine.h"
#include "run.h"

namespace gnomon::cli {

struct RenderArguments {
  std::string scene;                         ///< either a scene file
  std::string heightmap;                     ///< or an image of heights
  std::optional<std::array<double, 2>> sun;  ///< azimuth, elevation in degrees
  std::optional<ephemeris::Utc> time;        ///< or when
  std::optional<std::array<double, 2>> at;   ///< and where: latitude, longitude in degrees
  std::optional<std::string> method;
  std::optional<int> q;
  std::optional<double> receiver_height;         ///< metres
  std::optional<std::array<int, 2>> size;        ///< pixels
  std::optional<std::array<double, 2>> spacing;  ///< metres
  std::optional<double> vertical_scale;          ///< metres per stored unit
  std::optional<std::string> channel;
  std::optional<terrain::RawLayout> raw;
  std::optional<double> nodata;        ///< stored number
  std::vector<std::string> overrides;  ///< KEY=VALUE
  Backend backend = Backend::kAuto;
  std::string device;  ///< empty: any
  std::string target = "glsl450";
  std::string output;
};

struct TestArguments {
  std::vector<std::string> paths;
  std::vector<std::string> filters;
  int jobs = 0;  ///< 0: one a core
  std::string shard = "1/1";
  Backend backend = Backend::kAuto;
  std::string device;  ///< empty: any
  std::string target = "glsl450";
  std::string report;  ///< empty: no page
  UpdateGoldens update = UpdateGoldens::kNone;
  bool list = false;
  double timeout = 120;  ///< seconds a test
  std::vector<std::string> overrides;
  bool worker = false;  ///< we are a worker of such a run
};

struct DiffArguments {
  std::string actual, expected, output;
  std::vector<std::string> channels;    ///< empty: all of EXPECTED
  std::vector<std::string> tolerances;  ///< [CHANNEL=]ABS
  double max_mismatch = 0;
};

struct ValidateArguments {
  std::vector<std::string> scenes;
  std::vector<std::string> overrides;
};

struct NewArguments {
  std::string name;
};

struct BenchArguments {
  std::string experiment = "methods";
  std::vector<int> sizes;           ///< samples a side; empty: the experiment's own
  std::optional<double> elevation;  ///< degrees; absent: the experiment's own
  int rounds = 5;
  std::string scene;     ///< a file whose map is looked at too; empty: none
  std::string pictures;  ///< folder; empty: none
  Backend backend = Backend::kAuto;
  std::string device;  ///< empty: any
  std::string json;
};

struct TraceArguments {
  std::string scene;
  std::optional<std::array<int, 2>> pixel;  ///< column and row of the image; always given
  std::vector<std::string> filters;
  std::optional<std::string> method;
  std::vector<std::string> overrides;  ///< KEY=VALUE
  std::string json;                    ///< empty: none is written
};

struct InfoArguments {};

using Command = std::variant<RenderArguments, TestArguments, DiffArguments, ValidateArguments, NewArguments,
                             BenchArguments, TraceArguments, InfoArguments>;

/// A command, or a text to print (--help, --version, wrong usage) and the exit code.
struct CommandLine {
  std::optional<Command> command;
  std::string text;
  int exit_code = 0;
};

[[nodiscard]] CommandLine parse_arguments(int argc, const char* const* argv);

/// What changes the pictures of a test run, as words of a command line; nothing where all is at its default.
[[nodiscard]] std::vector<std::string> rendering_flags(const TestArguments& arguments);

/// The options of a test run as arguments for its workers.
[[nodiscard]] std::vector<std::string> worker_arguments(const TestArguments& arguments);

}  // namespace gnomon::cli
