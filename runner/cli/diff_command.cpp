// SPDX-License-Identifier: MIT
#include <charconv>
#include <cmath>
#include <filesystem>
#include <system_error>

#include "cli/commands.h"
#include "image/image.h"
#include "judge/judge.h"

namespace gnomon::cli {
namespace {

/// "0.5" for every channel or "k_shadow=0.5" for one.
Result<Done> add_tolerance(const std::string& text, judge::CompareOptions& options) {
  const std::size_t equals = text.find('=');
  const std::string number = equals == std::string::npos ? text : text.substr(equals + 1);
  double value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || end != number.data() + number.size() || !std::isfinite(value) || value < 0) {
    return Diagnostic{.file = "--tolerance " + text,
                      .message = "expected [CHANNEL=]ABS with a number that is at least 0"};
  }
  if (equals == std::string::npos) {
    options.default_tolerance = value;
  } else {
    options.tolerance[text.substr(0, equals)] = value;
  }
  return Done{};
}

/// Fills in the channels to compare: those that `--channel` names, else all of the expected image but the
/// band. A golden leaves out the steps; two renders that someone compares by hand do not.
Result<Done> name_channels(const DiffArguments& arguments, const image::Image& expected,
                           judge::CompareOptions& options) {
  options.channels = {arguments.channels.begin(), arguments.channels.end()};
  const auto lacks = [&](const std::string& option, const std::string& name) {
    return Diagnostic{.file = option + " " + name, .message = arguments.expected + " has no such channel"};
  };
  for (const std::string& name : arguments.channels) {
    if (!expected.channel(name)) return lacks("--channel", name);
  }
  for (const auto& [name, tolerance] : options.tolerance) {
    if (!expected.channel(name)) return lacks("--tolerance", name);
  }
  for (const auto& [name, values] : expected.channels) {
    if (arguments.channels.empty() && name != "band") options.channels.insert(name);
  }
  return Done{};
}

}  // namespace

int run_command(const DiffArguments& arguments, Console& console) {
  if (!arguments.output.empty() && std::filesystem::path(arguments.output).extension() != ".png") {
    return report(console,
                  {{.file = arguments.output, .message = "the picture of the difference is a .png"}});
  }
  std::error_code error;
  if (std::filesystem::equivalent(arguments.output, arguments.actual, error) ||
      std::filesystem::equivalent(arguments.output, arguments.expected, error)) {
    return report(console, {{.file = arguments.output,
                             .message = "is one of the images to compare: write to another file"}});
  }
  judge::CompareOptions options{.max_mismatch = arguments.max_mismatch};
  for (const std::string& text : arguments.tolerances) {
    if (const Result<Done> added = add_tolerance(text, options); !added)
      return report(console, added.diagnostics());
  }
  const Result<image::Image> actual = image::read_image(arguments.actual);
  const Result<image::Image> expected = image::read_image(arguments.expected);
  int code = actual ? 0 : report(console, actual.diagnostics());
  if (!expected) code = worse(code, report(console, expected.diagnostics()));
  if (code != 0) return code;

  if (const Result<Done> named = name_channels(arguments, *expected, options); !named)
    return report(console, named.diagnostics());
  const judge::Verdict verdict = judge::compare(*actual, *expected, options);
  console.out << (verdict.passed ? "same: " : "different: ") << verdict.measured
              << ", allowed: " << verdict.limit << "\n";
  if (verdict.worst && !verdict.passed) {
    console.out << "worst pixel (" << verdict.worst->x << ", " << verdict.worst->y
                << "): " << verdict.worst->channel << " is " << verdict.worst->actual << ", expected "
                << verdict.worst->expected << "\n";
  }
  if (!arguments.output.empty()) {
    const Result<Done> written =
        image::write_png(arguments.output, judge::difference_picture(*actual, *expected, options));
    if (!written) return report(console, written.diagnostics());
    console.out << arguments.output << "\n";
  }
  return verdict.passed ? 0 : 1;
}

}  // namespace gnomon::cli
