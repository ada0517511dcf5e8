// SPDX-License-Identifier: MIT
#include "scene/load.h"

#include <algorithm>
#include <utility>

#include "scene/build.h"
#include "scene/edit.h"
#include "scene/json.h"
#include "scene/matrix.h"
#include "scene/project.h"
#include "scene/report.h"
#include "scene/schema.h"
#include "scene/shape.h"

namespace gnomon::scene {
namespace {

using json::Value;

/// A matrix that brings a mistake in each combination is not tried to its end.
constexpr std::size_t kEnoughErrors = 100;
/// Inline heights that the tests of one file may hold together: half a gigabyte.
constexpr std::size_t kMostHeights = std::size_t{1} << 26U;

/// The --set arguments, and their names as Report wants them.
struct Overrides {
  std::vector<Override> values;
  std::vector<std::string> sources;
  Diagnostics diagnostics;
};

Overrides parse_overrides(const std::vector<std::string>& arguments, const std::string& file) {
  Overrides overrides{{}, {file}, {}};
  for (const std::string& argument : arguments) {
    Result<Override> parsed = parse_override(argument, static_cast<int>(overrides.sources.size()));
    overrides.sources.push_back("--set " + argument.substr(0, argument.find('=')));
    if (parsed) {
      overrides.values.push_back(*std::move(parsed));
    } else {
      overrides.diagnostics.insert(overrides.diagnostics.end(), parsed.diagnostics().begin(),
                                   parsed.diagnostics().end());
    }
  }
  return overrides;
}

/// The shape of one combination. What no axis changes has been checked with the first one, and between sound
/// key frames lie sound frames.
void check_combination(const Combination& combination, const Matrix& matrix, bool first, Report& report) {
  const Value& root = combination.root;
  for (const Problem& problem : combination.problems)
    report.error(problem.place, problem.pointer, problem.message);
  if (first) return check_shape(scene_schema(), root, "", report);
  if (combination.frame && combination.frame->number > 0) return;
  for (const json::Member& member : root.get_if<json::Object>() ? root.object() : json::Object{}) {
    const Value* schema = member_schema(scene_schema(), member.key);
    if (schema && matrix.changes(member.key))
      check_shape(*schema, member.value, json::child("", member.key), report);
  }
}

/// `root` without the sections that break their schema, so that the others can be checked further.
Value sound_sections(Value root, const Report& report) {
  if (!root.get_if<json::Object>()) return {json::Object{}};
  std::erase_if(*root.get_if<json::Object>(), [&](const json::Member& member) {
    const Value* schema = member_schema(scene_schema(), member.key);
    Report scratch = report.fresh();
    if (schema) check_shape(*schema, member.value, "", scratch);
    return !schema || !scratch.ok();
  });
  return root;
}

/// Where the value at a JSON pointer was written, or its nearest container that was.
json::Place place_of(const Value& root, const std::string& pointer) {
  for (std::string key = pointer.substr(1); !key.empty(); key.resize(key.find_last_of('.'))) {
    std::replace(key.begin(), key.end(), '/', '.');
    if (const Value* value = find_value(root, key)) return value->place;
    if (key.find('.') == std::string::npos) break;
  }
  return root.place;
}

void check_known_size(const Scene& scene, const Value& root, const Vocabulary& vocabulary, Report& report) {
  const std::optional<std::array<int, 2>> size = map_size(scene, vocabulary);
  if (!size) return;
  for (const SizeProblem& problem : size_problems(scene, *size)) {
    report.error(place_of(root, problem.pointer), problem.pointer, problem.message);
  }
}

/// One test for each combination; what is returned counts only if the report stays empty.
std::vector<Scene> build_tests(const Matrix& matrix, const BuildContext& context, const std::string& id,
                               Report& report) {
  std::vector<Scene> tests;
  std::size_t heights = 0;
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    Combination combination = matrix.at(i);
    report.set_aliases(std::move(combination.aliases));
    check_combination(combination, matrix, i == 0, report);
    if (!report.ok()) combination.root = sound_sections(std::move(combination.root), report);
    Scene scene = build_scene(combination.root, context, report);
    check_known_size(scene, combination.root, context.vocabulary, report);
    const InlineTerrain* written = std::get_if<InlineTerrain>(&scene.terrain.source);
    heights += written ? written->heights.size() : 0;
    if (heights > kMostHeights) {
      report.error(place_of(combination.root, "/terrain"), "/terrain",
                   "too many heights for a matrix of this size; keep them in an image file");
    }
    if (report.count() > kEnoughErrors || heights > kMostHeights) break;
    scene.id = id + combination.suffix;
    scene.frame = combination.frame;
    scene.golden_file = golden_file(context.project, scene.id);
    tests.push_back(std::move(scene));
  }
  return tests;
}

}  // namespace

LoadResult load_scene(const std::string& path, const std::vector<std::string>& overrides,
                      const Vocabulary& vocabulary) {
  const Result<std::string> text = read_text(path);
  if (!text) return {{}, text.diagnostics()};
  const Result<Project> project = find_project(path);
  if (!project) return {{}, project.diagnostics()};

  Overrides set = parse_overrides(overrides, path);
  Report report(set.sources);
  report.add(set.diagnostics);
  json::Parsed parsed = json::parse(*text, path);
  report.add(parsed.diagnostics);
  if (!parsed.root) return {{}, report.take()};

  const Value* written = parsed.root->find("matrix");
  if (written) check_shape(*member_schema(scene_schema(), "matrix"), *written, "/matrix", report);
  const Matrix matrix(*std::move(parsed.root), std::move(set.values), report);
  std::vector<Scene> tests =
      build_tests(matrix, {vocabulary, *project, path}, test_id(*project, path), report);
  if (!report.ok()) return {{}, report.take()};
  for (Scene& test : tests) test.overrides = overrides;
  return {std::move(tests), {}};
}

Diagnostics check_size(const Scene& scene, int width, int height) {
  Diagnostics diagnostics;
  for (const SizeProblem& problem : size_problems(scene, {width, height})) {
    diagnostics.push_back({scene.file, 0, 0, problem.pointer + ": " + problem.message});
  }
  return diagnostics;
}

}  // namespace gnomon::scene
