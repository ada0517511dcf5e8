// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <optional>
#include <thread>

#include "cli/commands.h"
#include "cli/request.h"
#include "report/progress.h"
#include "report/report.h"
#include "report/test_result_json.h"
#include "scene/discover.h"
#include "scene/project.h"
#include "worker/pool.h"

namespace gnomon::cli {
namespace {

using report::Status;
using report::TestResult;

struct Planned {
  std::vector<Request> requests;    // the tests of this shard
  std::vector<TestResult> invalid;  // scene files that make none
  std::size_t chosen = 0;           // tests of all shards that the filters let through
};

TestResult invalid_scene(const std::string& file, const Diagnostics& diagnostics) {
  TestResult result;
  result.id = file;
  result.scene_file = file;
  result.status = Status::kInvalid;
  for (const Diagnostic& diagnostic : diagnostics)
    result.error += (result.error.empty() ? "" : "\n") + to_string(diagnostic);
  return result;
}

/// Adds the chosen tests of a scene. Two files that make the same id would share a golden.
void add_tests(const std::vector<scene::Scene>& tests, const TestArguments& arguments,
               const scene::Shard& shard, const std::string& program,
               std::map<std::string, std::string>& file_of_id, Planned& planned) {
  for (const scene::Scene& test : tests) {
    if (!scene::is_chosen(arguments.filters, test.id)) continue;
    const auto [other, is_new] = file_of_id.emplace(test.id, test.file);
    if (!is_new) {
      planned.invalid.push_back(invalid_scene(
          test.file, {{.file = test.file,
                       .message = "makes the test '" + test.id + "', as " + other->second +
                                  " does; run them apart, or put both into one project (gnomon.json)"}}));
      return;
    }
    if (shard.contains(planned.chosen++)) planned.requests.push_back({test.file, test.id, program});
  }
}

/// Whether the filters could let a test of this file through, whose matrix cannot be read: only its id before
/// '@' is known.
bool may_choose(std::vector<std::string> filters, const std::string& file) {
  const Result<scene::Project> project = scene::find_project(file);
  if (!project) return true;
  for (std::string& filter : filters) filter.resize(std::min(filter.find('@'), filter.size()));
  return scene::is_chosen(filters, scene::test_id(*project, file));
}

Planned plan(const std::vector<std::string>& files, const TestArguments& arguments, const scene::Shard& shard,
             const std::string& program) {
  Planned planned;
  const scene::Vocabulary words = vocabulary();
  std::map<std::string, std::string> file_of_id;
  for (const std::string& file : files) {
    const scene::LoadResult loaded = scene::load_scene(file, arguments.overrides, words);
    if (!loaded.diagnostics.empty() && may_choose(arguments.filters, file)) {
      planned.invalid.push_back(invalid_scene(file, loaded.diagnostics));
    }
    add_tests(loaded.tests, arguments, shard, program, file_of_id, planned);
  }
  return planned;
}

int code_of(const TestResult& result) {
  switch (result.status) {
    case Status::kPassed:
      return 0;
    case Status::kFailed:
      return 1;
    case Status::kInvalid:
      return 2;
    case Status::kSkipped:
      return 77;
    case Status::kMachine:
      return 99;
  }
  return 99;
}

/// 77 only where all that was asked for was skipped.
int code_of(const std::vector<TestResult>& results) {
  int code = results.empty() ? 0 : 77;
  const bool all_skipped =
      !results.empty() && std::all_of(results.begin(), results.end(),
                                      [](const TestResult& r) { return r.status == Status::kSkipped; });
  if (!all_skipped) code = 0;
  for (const TestResult& result : results) {
    if (result.status != Status::kSkipped) code = worse(code, code_of(result));
  }
  return code;
}

TestResult result_of(const Request& request, const worker::Outcome& outcome, const TestArguments& arguments) {
  if (outcome.failure.empty()) {
    Result<TestResult> result = report::from_json(outcome.answer);
    if (result && result->id == request.id) return std::move(result).value();
  }
  TestResult result;
  result.id = request.id;
  result.scene_file = request.scene_file;
  result.status = Status::kFailed;
  result.error = outcome.failure.empty() ? "its worker gave no valid answer" : outcome.failure;
  const RunOptions options{.flags = rendering_flags(arguments), .program = request.program};
  result.reproduce = reproduce_command(request.scene_file, request.id, options);
  return result;
}

/// What became of the tests, in the order of the plan; those that an interrupt or a failing machine left out
/// are absent.
struct TestRun {
  std::vector<TestResult> results;
  Diagnostics diagnostics;  // of the machine
};

TestRun run_tests(const std::vector<Request>& requests, const TestArguments& arguments, Console& console) {
  std::vector<std::string> lines;
  for (const Request& request : requests) lines.push_back(to_json(request));
  std::vector<std::optional<TestResult>> results(requests.size());
  report::Progress progress{
      .finished = 0, .total = requests.size(), .terminal = console.terminal, .columns = console.columns};
  const worker::Listener listener{
      .begun =
          [&](std::size_t job) {
            console.err << report::test_begun(progress, requests[job].id) << std::flush;
          },
      .done =
          [&](std::size_t job, const worker::Outcome& outcome) {
            results[job] = result_of(requests[job], outcome, arguments);
            ++progress.finished;
            console.err << report::test_finished(progress, *results[job]) << std::flush;
          }};
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  const worker::PoolOptions options{
      .executable = console.executable,
      .arguments = worker_arguments(arguments),
      .workers = arguments.jobs > 0 ? arguments.jobs : static_cast<int>(cores),
      .timeout = std::chrono::milliseconds(static_cast<long>(arguments.timeout * 1000))};
  const Result<Done> ran = worker::run_pool(lines, options, console.interrupted, listener);
  console.err << report::run_finished(progress) << std::flush;
  TestRun run{.results = {}, .diagnostics = ran ? Diagnostics{} : ran.diagnostics()};
  for (std::optional<TestResult>& result : results) {
    if (result) run.results.push_back(*std::move(result));
  }
  return run;
}

void print(const std::vector<TestResult>& results, Console& console) {
  for (const TestResult& result : results) {
    if (!result.golden_note.empty())
      console.out << "golden " << result.golden_note << ": " << result.id << "\n";
    if (result.status != Status::kPassed) console.out << report::failure_text(result) << "\n";
  }
}

int write_report(const std::vector<TestResult>& results, const TestArguments& arguments, Console& console) {
  if (arguments.report.empty()) return 0;
  Engine engine(
      {.shader_library = console.shader_library, .backend = arguments.backend, .device = arguments.device});
  const Result<const gl::Info*> info = engine.gl_info();
  const report::PageInfo page{
      .title = "gnomon test",
      .renderer = info ? (*info)->renderer + ", OpenGL " + (*info)->version : "no OpenGL",
      .version = GNOMON_VERSION};
  const Result<Done> written = report::write_page(arguments.report, results, page);
  if (!written) return report(console, written.diagnostics());
  console.out << "report: " << arguments.report << "/index.html\n";
  return 0;
}

/// A back end or a device that was asked for by name and is absent is said once, not by every test.
Result<Done> check_backend(const TestArguments& arguments, const Console& console) {
  const bool named = arguments.backend == Backend::kEgl || arguments.backend == Backend::kOsmesa;
  if (!named && arguments.device.empty()) return Done{};
  Engine engine(
      {.shader_library = console.shader_library, .backend = arguments.backend, .device = arguments.device});
  if (const Result<const gl::Info*> info = engine.gl_info(); !info) return info.diagnostics();
  return Done{};
}

int list(const Planned& planned, Console& console) {
  for (const Request& request : planned.requests) console.out << request.id << "\n";
  for (const TestResult& invalid : planned.invalid) console.err << invalid.error << "\n";
  return planned.invalid.empty() ? 0 : 2;
}

}  // namespace

int run_command(const TestArguments& arguments, Console& console) {
  if (arguments.worker) return serve(arguments, console);
  const Result<scene::Shard> shard = scene::parse_shard(arguments.shard);
  if (!shard) return report(console, shard.diagnostics());
  const Result<std::vector<std::string>> files = scene::find_scenes(arguments.paths);
  if (!files) return report(console, files.diagnostics());
  const Planned planned = plan(*files, arguments, *shard, console.program);
  if (planned.chosen == 0 && planned.invalid.empty()) {
    return report(console, {{.file = "--filter", .message = "matches no test; --list prints the ids"}});
  }
  if (arguments.list) return list(planned, console);
  if (const Result<Done> there = check_backend(arguments, console); !there)
    return report(console, there.diagnostics());

  const TestRun run = run_tests(planned.requests, arguments, console);
  std::vector<TestResult> results = planned.invalid;
  results.insert(results.end(), run.results.begin(), run.results.end());
  print(results, console);
  int code = worse(code_of(results), write_report(results, arguments, console));
  code = worse(code, report(console, run.diagnostics));
  if (console.interrupted) {
    console.out << "interrupted: " << run.results.size() << " of " << planned.requests.size()
                << " tests had finished\n";
    code = worse(code, static_cast<int>(Failure::kInterrupted));
  }
  console.out << report::summary_line(results) << "\n";
  return code;
}

}  // namespace gnomon::cli
