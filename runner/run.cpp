// SPDX-License-Identifier: MIT
#include "run.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <utility>

#include "golden.h"
#include "judge/judge.h"
#include "shell.h"

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using report::Status;
using report::TestResult;
using scene::Scene;

Status status_of(Failure failure) {
  if (failure == Failure::kFailed) return Status::kFailed;
  if (failure == Failure::kMachine) return Status::kMachine;
  if (failure == Failure::kSkipped) return Status::kSkipped;
  return Status::kInvalid;
}

void fail(TestResult& result, const Diagnostics& diagnostics) {
  result.status = status_of(diagnostics.front().failure);
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!result.error.empty()) result.error += "\n";
    result.error += to_string(diagnostic);
  }
}

const scene::GoldenExpectation* golden_expectation(const Scene& scene) {
  for (const scene::Expectation& expectation : scene.expect) {
    if (const auto* golden = std::get_if<scene::GoldenExpectation>(&expectation)) return golden;
  }
  return nullptr;
}

/// Everything a test is judged by. The oracle is asked only where an expectation or a golden to be written
/// needs it.
struct Gathered {
  Rendered rendered;
  std::optional<image::Image> golden;
  std::optional<image::Image> reference;
  std::map<int, image::Image> reference_at_level;

  [[nodiscard]] judge::Evidence evidence() const {
    judge::Evidence evidence{.actual = rendered.image,
                             .golden = golden ? &*golden : nullptr,
                             .reference = reference ? &*reference : nullptr};
    for (const auto& [level, image] : reference_at_level) evidence.reference_at_level[level] = &image;
    return evidence;
  }
};

Result<Done> ask_oracle(Engine& engine, const Scene& scene, Gathered& gathered) {
  if (gathered.reference) return Done{};
  Result<image::Image> reference = engine.reference(scene, gathered.rendered.ground);
  if (!reference) return reference.diagnostics();
  gathered.reference = std::move(reference).value();
  return Done{};
}

Result<Done> gather_references(Engine& engine, const Scene& scene, Gathered& gathered) {
  for (const scene::Expectation& expectation : scene.expect) {
    const auto* wanted = std::get_if<scene::ReferenceExpectation>(&expectation);
    if (!wanted) continue;
    if (!wanted->level) {
      if (Result<Done> asked = ask_oracle(engine, scene, gathered); !asked) return asked;
    } else {
      Result<image::Image> reference = engine.reference(scene, gathered.rendered.ground, *wanted->level);
      if (!reference) return reference.diagnostics();
      gathered.reference_at_level[*wanted->level] = std::move(reference).value();
    }
  }
  return Done{};
}

/// A golden that cannot be read fails the test, unless it is about to be replaced.
Result<Done> read_golden(const Scene& scene, UpdateGoldens update, Gathered& gathered) {
  std::error_code error;
  if (!golden_expectation(scene) || !fs::exists(scene.golden_file, error)) return Done{};
  Result<image::Image> golden = image::read_image(scene.golden_file);
  if (golden) {
    gathered.golden = std::move(golden).value();
  } else if (update != UpdateGoldens::kChanged && update != UpdateGoldens::kAll) {
    return golden.diagnostics();
  }
  return Done{};
}

Result<Gathered> gather(Engine& engine, const Scene& scene, UpdateGoldens update) {
  Result<Rendered> rendered = engine.render(scene);
  if (!rendered) return rendered.diagnostics();
  Gathered gathered{
      .rendered = std::move(rendered).value(), .golden = {}, .reference = {}, .reference_at_level = {}};
  if (Result<Done> asked = gather_references(engine, scene, gathered); !asked) return asked.diagnostics();
  if (Result<Done> read = read_golden(scene, update, gathered); !read) return read.diagnostics();
  return gathered;
}

bool golden_is_due(const Gathered& gathered, const scene::GoldenExpectation& expectation,
                   UpdateGoldens update) {
  if (update == UpdateGoldens::kNone) return false;
  if (!gathered.golden || update == UpdateGoldens::kAll) return true;
  return update == UpdateGoldens::kChanged &&
         !judge::judge({expectation}, gathered.evidence()).front().passed;
}

/// Writes the golden where it is due. Returns "written", "updated" or nothing.
Result<std::string> update_golden(Engine& engine, const Scene& scene, UpdateGoldens update,
                                  Gathered& gathered) {
  const scene::GoldenExpectation* expectation = golden_expectation(scene);
  if (!expectation || !golden_is_due(gathered, *expectation, update)) return std::string();
  if (Result<Done> asked = ask_oracle(engine, scene, gathered); !asked) return asked.diagnostics();
  const Result<std::vector<float>> unsteady = engine.unsteady(scene, gathered.rendered.image);
  if (!unsteady) return unsteady.diagnostics();
  const GoldenSource source{gathered.rendered.image, *gathered.reference, *unsteady};
  const Result<Done> written = write_golden(source, scene, *expectation);
  if (!written) return written.diagnostics();
  const std::string note = gathered.golden ? "updated" : "written";
  gathered.golden = make_golden(source, scene);
  return note;
}

/// The image that a person would want to see beside the actual one.
const image::Image* expected_image(const Gathered& gathered) {
  if (gathered.golden) return &*gathered.golden;
  if (gathered.reference) return &*gathered.reference;
  return gathered.reference_at_level.empty() ? nullptr : &gathered.reference_at_level.begin()->second;
}

/// The names of the files of one test, below the results' directory.
struct ResultFiles {
  fs::path folder;
  [[nodiscard]] std::string operator()(const char* name) const { return (folder / name).string(); }
};

Result<Done> write_pictures(const Scene& scene, const Gathered& gathered, const ResultFiles& files,
                            TestResult& result) {
  const image::Image& actual = gathered.rendered.image;
  const auto picture = [&](const image::Image& image) {
    return Engine::picture(gathered.rendered, scene, image);
  };
  result.actual_png = files("actual.png");
  if (Result<Done> done = image::write_png(result.actual_png, picture(actual)); !done) return done;
  const image::Image* expected = expected_image(gathered);
  const bool comparable = expected && expected->channel("k_shadow") && expected->pixels() == actual.pixels();
  if (!comparable) return Done{};
  result.expected_png = files("expected.png");
  result.difference_png = files("difference.png");
  if (Result<Done> done = image::write_png(result.expected_png, picture(*expected)); !done) return done;
  judge::CompareOptions options{.channels = {"b_shadow"}};
  return image::write_png(result.difference_png, judge::difference_picture(actual, *expected, options));
}

Result<Done> write_images(const Scene& scene, const Gathered& gathered, const RunOptions& options,
                          TestResult& result) {
  const ResultFiles files{fs::path(options.results_directory) / scene.id};
  std::error_code error;
  fs::create_directories(files.folder, error);
  if (Result<Done> done = write_pictures(scene, gathered, files, result); !done) return done;
  if (result.status == Status::kPassed) return Done{};
  result.actual_exr = files("actual.exr");
  if (Result<Done> done = image::write_exr(result.actual_exr, gathered.rendered.image); !done) return done;
  const image::Image* expected = expected_image(gathered);
  if (!expected) return Done{};
  if (gathered.golden) {
    result.expected_exr = scene.golden_file;
    return Done{};
  }
  result.expected_exr = files("expected.exr");
  return image::write_exr(result.expected_exr, *expected);
}

TestResult describe(const Scene& scene, const RunOptions& options) {
  TestResult result;
  result.id = scene.id;
  result.scene_file = scene.file;
  result.description = scene.description;
  result.reproduce = reproduce_command(scene.file, scene.id, options);
  return result;
}

/// Accepting a golden mends a failed golden and nothing else.
std::string accept_command(const Scene& scene, const Gathered& gathered, const TestResult& result) {
  for (std::size_t i = 0; i < scene.expect.size(); ++i) {
    const bool is_golden = std::holds_alternative<scene::GoldenExpectation>(scene.expect[i]);
    if (!is_golden || result.verdicts[i].passed) continue;
    return result.reproduce + " --update-goldens " + (gathered.golden ? "changed" : "missing");
  }
  return {};
}

}  // namespace

std::string reproduce_command(const std::string& scene_file, const std::string& id,
                              const RunOptions& options) {
  std::string command = quote(options.program) + " test " + quote(scene_file) + " --filter " + quote(id);
  for (const std::string& flag : options.flags) command += " " + quote(flag);
  return command;
}

TestResult run_test(Engine& engine, const Scene& scene, const RunOptions& options) {
  const auto begin = std::chrono::steady_clock::now();
  TestResult result = describe(scene, options);
  Result<Gathered> gathered = gather(engine, scene, options.update);
  if (!gathered) {
    fail(result, gathered.diagnostics());
    return result;
  }
  const Result<std::string> updated = update_golden(engine, scene, options.update, *gathered);
  if (updated) {
    result.golden_note = *updated;
  } else {
    fail(result, updated.diagnostics());
  }
  result.verdicts = judge::judge(scene.expect, gathered->evidence());
  result.accept = accept_command(scene, *gathered, result);
  const bool held =
      std::all_of(result.verdicts.begin(), result.verdicts.end(), [](const auto& v) { return v.passed; });
  if (!held && result.status == Status::kPassed) result.status = Status::kFailed;
  if (options.pictures_of_all || result.status != Status::kPassed) {
    if (const Result<Done> written = write_images(scene, *gathered, options, result); !written)
      fail(result, written.diagnostics());
  }
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return result;
}

}  // namespace gnomon
