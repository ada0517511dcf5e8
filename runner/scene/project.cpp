// SPDX-License-Identifier: MIT
#include "scene/project.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "scene/json.h"
#include "scene/report.h"
#include "scene/schema.h"
#include "scene/shape.h"

namespace gnomon::scene {
namespace {

namespace fs = std::filesystem;

/// Whether `path` is `root` or lies below it; both absolute and without "." and "..".
bool is_below(const fs::path& path, const fs::path& root) {
  const auto [in_root, in_path] = std::mismatch(root.begin(), root.end(), path.begin(), path.end());
  static_cast<void>(in_path);
  return in_root == root.end();
}

/// Absolute and normal by its text alone; symbolic links stay.
fs::path absolute_text(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error).lexically_normal();
  return absolute.has_filename() ? absolute : absolute.parent_path();  // no trailing slash
}

/// `absolute` as the user would write it beside `example`.
fs::path shown_like(const fs::path& absolute, const fs::path& example) {
  if (example.is_absolute()) return absolute;
  std::error_code error;
  return absolute.lexically_proximate(fs::current_path(error));
}

std::string join(const fs::path& folder, const fs::path& name) {
  return (folder / name).lexically_normal().generic_string();
}

/// One of the project's folders: below its root, or an error.
std::string folder_of(const json::Value& file, const char* key, const Project& project, Report& report) {
  const json::Value* written = file.find(key);
  const fs::path name =
      written ? written->text() : member_schema(project_schema(), key)->find("default")->text();
  const bool leaves = name.is_absolute() || !is_below(("/r" / name).lexically_normal(), "/r");
  if (written && leaves) {
    report.error(
        written->place, json::child("", key),
        "expected a folder inside the project, relative to the folder of gnomon.json, got " + dump(*written));
  }
  return join(project.root, name);
}

Result<Project> read_project(Project project, const std::string& path) {
  const Result<std::string> text = read_text(path);
  if (!text) return text.diagnostics();
  json::Parsed parsed = json::parse(*text, path);
  Report report({path});
  report.add(parsed.diagnostics);
  if (parsed.root) check_shape(project_schema(), *parsed.root, "", report);
  if (!report.ok()) return report.take();
  project.scenes = folder_of(*parsed.root, "scenes", project, report);
  project.goldens = folder_of(*parsed.root, "goldens", project, report);
  if (const json::Value* includes = parsed.root->find("includes")) {
    for (const json::Value& folder : includes->array())
      project.includes.push_back(join(project.root, folder.text()));
  }
  if (!report.ok()) return report.take();
  project.has_file = true;
  return project;
}

}  // namespace

Result<Project> find_project(const std::string& scene_or_directory) {
  const fs::path given = scene_or_directory.empty() ? "." : scene_or_directory;
  std::error_code error;
  const fs::path start = absolute_text(given);
  const fs::path folder = fs::is_directory(start, error) ? start : start.parent_path();
  for (fs::path at = folder;; at = at.parent_path()) {
    if (fs::exists(at / kProjectFile, error)) {
      Project project{shown_like(at, given).generic_string(), "", "", {}, false};
      return read_project(std::move(project), join(project.root, kProjectFile));
    }
    if (at == at.root_path()) break;
  }
  const json::Value none{json::Object{}};
  Project project{shown_like(folder, given).generic_string(), "", "", {}, false};
  Report report({""});
  project.scenes = folder_of(none, "scenes", project, report);
  project.goldens = folder_of(none, "goldens", project, report);
  return project;
}

std::string test_id(const Project& project, const std::string& scene_file) {
  const fs::path file = absolute_text(scene_file);
  for (const std::string& folder : {project.scenes, project.root}) {
    const fs::path absolute = absolute_text(folder);
    if (is_below(file, absolute))
      return file.lexically_relative(absolute).replace_extension().generic_string();
  }
  return file.stem().generic_string();
}

std::string golden_file(const Project& project, const std::string& test_id) {
  return join(project.goldens, test_id + ".exr");
}

Result<InsideFile> resolve_inside(const Project& project, const std::string& directory,
                                  const std::string& name) {
  const fs::path path = name;
  std::error_code error;
  if (name.find('\0') != std::string::npos) return Diagnostic{"", 0, 0, "the path contains a NUL character"};
  if (path.is_absolute()) {
    return Diagnostic{"", 0, 0, "the path is absolute; expected one relative to the scene file"};
  }
  const fs::path root = fs::canonical(absolute_text(project.root), error);
  const fs::path target = error ? fs::path() : fs::weakly_canonical(absolute_text(directory) / path, error);
  if (error || !is_below(target, root)) {
    return Diagnostic{
        "", 0, 0, "the path leads out of the project (the folder of gnomon.json, else that of the scene)"};
  }
  const fs::path shown = directory.empty() ? path : directory / path;
  if (!fs::exists(target, error)) return Diagnostic{"", 0, 0, "there is no file " + shown.generic_string()};
  if (!fs::is_regular_file(target, error))
    return Diagnostic{"", 0, 0, shown.generic_string() + " is not a file"};
  return InsideFile{shown.generic_string(), target.lexically_relative(root).generic_string()};
}

Result<std::string> read_text(const std::string& path) {
  constexpr std::uintmax_t kLargest = 64U << 20U;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return Diagnostic{path, 0, 0, "there is no such file"};
  if (fs::is_directory(status)) return Diagnostic{path, 0, 0, "this is a folder; expected a JSON file"};
  if (!fs::is_regular_file(status))
    return Diagnostic{path, 0, 0, "this is not a regular file; expected a JSON file"};
  if (fs::file_size(path, error) > kLargest) return Diagnostic{path, 0, 0, "the file is larger than 64 MiB"};
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return Diagnostic{path, 0, 0, std::string("the file cannot be read: ") + std::strerror(errno)};
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) return Diagnostic{path, 0, 0, "the file cannot be read to its end"};
  return text;
}

}  // namespace gnomon::scene
