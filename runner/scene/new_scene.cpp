// SPDX-License-Identifier: MIT
#include "scene/new_scene.h"

#include <algorithm>
#include <filesystem>

#include "scene/project.h"
#include "scene/schema.h"

namespace gnomon::scene {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSchemaFile = "scene.schema.json";

bool is_scene_path(const std::string& name) {
  const fs::path path(name);
  const bool plain = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c < 128 && std::isalnum(c) != 0) ||
           std::string_view("_-.+/").find(static_cast<char>(c)) != std::string::npos;
  });
  const bool whole = name.find("//") == std::string::npos && path.has_filename() && !path.stem().empty() &&
                     !path.is_absolute();
  return plain && whole && std::none_of(path.begin(), path.end(), [](const fs::path& part) {
           return part.empty() || part.native().starts_with('.');
         });
}

/// The schema that the project carries already, or where it is to be written.
fs::path schema_file(const fs::path& root) {
  std::error_code error;
  const fs::path in_docs = root / "docs" / kSchemaFile;
  return fs::exists(in_docs, error) ? in_docs : root / kSchemaFile;
}

}  // namespace

Result<std::vector<NewFile>> new_scene(const std::string& name, const std::string& directory) {
  const std::string bare = name.ends_with(".json") ? name.substr(0, name.size() - 5) : name;
  if (!is_scene_path(bare)) {
    return Diagnostic{"", 0, 0,
                      "\"" + name +
                          "\" is no name for a scene; expected a path such as area/case, of letters, digits "
                          "and _ - . +, no part beginning with a dot"};
  }
  const Result<Project> project = find_project(directory);
  if (!project) return project.diagnostics();
  const fs::path scene = fs::path(project->scenes) / (bare + ".json");
  const fs::path schema = schema_file(project->root);
  std::error_code error;
  if (fs::exists(scene, error)) {
    return Diagnostic{scene.generic_string(), 0, 0,
                      "the scene exists already; choose another name or remove it"};
  }
  const fs::path reference =
      schema.lexically_normal().lexically_relative(scene.parent_path().lexically_normal());
  std::vector<NewFile> files{{scene.generic_string(), new_scene_text(reference.generic_string())}};
  if (!project->has_file) {
    files.push_back(
        {(fs::path(project->root) / kProjectFile).lexically_normal().generic_string(), new_project_text()});
  }
  if (!fs::exists(schema, error)) {
    files.push_back({schema.lexically_normal().generic_string(), std::string(schema_text())});
  }
  return files;
}

std::string new_scene_text(const std::string& schema) {
  // The wall stands in column 4; columns 5 to 9 lie 1 to 5 m behind it, in shadow, and column 10 lies 6 m
  // behind it.
  return R"({
  "$schema": ")" +
         schema + R"(",
  "version": 1,
  "description": "A wall 5.5 m high, 45 degree sun square to it: its shadow is 5.5 m / tan(45 degrees) = 5.5 m long",
  "terrain": {
    "heights": [
      [0, 0, 0, 0, 5.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
      [0, 0, 0, 0, 5.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
      [0, 0, 0, 0, 5.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
      [0, 0, 0, 0, 5.5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0]
    ],
    "spacing": 1
  },
  "sun": { "azimuth": 270, "elevation": 45 },
  "camera": { "map": {} },
  "shadow": { "method": "multilevel", "q": 0 },
  "expect": [
    { "reference": {} },
    { "probe": { "at": [3, 1], "b_shadow": 0 } },
    { "probe": { "at": [5, 1], "b_shadow": 1 } },
    { "probe": { "at": [9, 1], "b_shadow": 1 } },
    { "probe": { "at": [10, 1], "b_shadow": 0 } },
    { "max_steps": 160 }
  ]
}
)";
}

std::string new_project_text() {
  return R"({
  "$schema": "scene.schema.json#/definitions/project",
  "version": 1,
  "scenes": "testcases",
  "goldens": "goldens",
  "includes": []
}
)";
}

}  // namespace gnomon::scene
