// SPDX-License-Identifier: MIT
#include <exception>
#include <istream>
#include <optional>
#include <string>

#include "cli/commands.h"
#include "cli/request.h"
#include "report/test_result_json.h"
#include "run.h"
#include "scene/project.h"

namespace gnomon::cli {
namespace {

/// Keeps the engine (context, programs, terrain) and the scene file of the test before: most tests share
/// them.
class Server {
 public:
  Server(const TestArguments& arguments, const Console& console)
      : arguments_(arguments), console_(console), vocabulary_(vocabulary()) {}

  report::TestResult run(const Request& request) {
    if (request.scene_file != file_) load(request.scene_file);
    for (const scene::Scene& scene : tests_) {
      if (scene.id == request.id) return run(scene, request);
    }
    report::TestResult result;
    result.id = request.id;
    result.scene_file = request.scene_file;
    result.status = report::Status::kInvalid;
    result.error = request.scene_file + ": error: changed while the tests ran; run them again";
    return result;
  }

 private:
  /// An exception that a library lets out (memory, most likely) costs its own test only.
  report::TestResult run(const scene::Scene& scene, const Request& request) {
    try {
      return run_test(*engine_, scene, options(request));
    } catch (const std::exception& exception) {
      report::TestResult result;
      result.id = scene.id;
      result.scene_file = scene.file;
      result.status = report::Status::kMachine;
      result.error = std::string("error: out of resources: ") + exception.what();
      return result;
    }
  }

  void load(const std::string& file) {
    file_ = file;
    tests_ = scene::load_scene(file, arguments_.overrides, vocabulary_).tests;
    const Result<scene::Project> project = scene::find_project(file);
    const std::vector<std::string> includes = project ? project->includes : std::vector<std::string>{};
    if (engine_ && includes == includes_) return;
    includes_ = includes;
    engine_.emplace(EngineOptions{.shader_library = console_.shader_library,
                                  .includes = includes,
                                  .target = arguments_.target,
                                  .backend = arguments_.backend,
                                  .device = arguments_.device});
  }

  [[nodiscard]] RunOptions options(const Request& request) const {
    RunOptions options{.update = arguments_.update,
                       .pictures_of_all = !arguments_.report.empty(),
                       .program = request.program};
    if (!arguments_.report.empty()) options.results_directory = arguments_.report;
    options.flags = rendering_flags(arguments_);
    return options;
  }

  const TestArguments& arguments_;
  const Console& console_;
  scene::Vocabulary vocabulary_;
  std::string file_;
  std::vector<scene::Scene> tests_;
  std::vector<std::string> includes_;
  std::optional<Engine> engine_;
};

}  // namespace

int serve(const TestArguments& arguments, Console& console) {
  Server server(arguments, console);
  for (std::string line; std::getline(console.in, line);) {
    const std::optional<Request> request = request_from_json(line);
    if (!request) return 2;
    console.out << report::to_json(server.run(*request)) << std::endl;
  }
  return 0;
}

}  // namespace gnomon::cli
