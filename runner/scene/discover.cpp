// SPDX-License-Identifier: MIT
#include "scene/discover.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>

#include "scene/project.h"

namespace gnomon::scene {
namespace {

namespace fs = std::filesystem;

bool is_scene_name(const fs::path& path) {
  const std::string name = path.filename().string();
  return path.extension() == ".json" && name != kProjectFile && !name.ends_with(".schema.json");
}

/// Adds the scene files of a folder and of those in it; hidden ones are left out, links to folders not
/// followed.
Result<Done> add_folder(const fs::path& folder, std::set<std::string>& files) {
  std::error_code error;
  bool found = false;
  fs::recursive_directory_iterator entry(folder, error);
  while (!error && entry != fs::recursive_directory_iterator()) {
    const bool hidden = entry->path().filename().string().starts_with('.');
    if (hidden) {
      entry.disable_recursion_pending();
    } else if (is_scene_name(entry->path()) && entry->is_regular_file(error)) {
      files.insert(entry->path().lexically_normal().generic_string());
      found = true;
    }
    entry.increment(error);
  }
  if (error)
    return Diagnostic{folder.generic_string(), 0, 0, "the folder cannot be read: " + error.message()};
  if (!found) return Diagnostic{folder.generic_string(), 0, 0, "the folder holds no scene files (*.json)"};
  return Done{};
}

/// The folder of scenes that a folder stands for: a project's root stands for its scenes.
Result<std::string> scenes_folder(const std::string& folder) {
  std::error_code error;
  if (!fs::exists(fs::path(folder) / kProjectFile, error)) return folder;
  const Result<Project> project = find_project(folder);
  if (!project) return project.diagnostics();
  return project->scenes;
}

Result<Done> add_path(const std::string& path, std::set<std::string>& files) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) return Diagnostic{path, 0, 0, "there is no such scene file or folder"};
  if (!fs::is_directory(status)) {
    files.insert(fs::path(path).lexically_normal().generic_string());
    return Done{};
  }
  const Result<std::string> folder = scenes_folder(path);
  if (!folder) return folder.diagnostics();
  return add_folder(*folder, files);
}

}  // namespace

Result<std::vector<std::string>> find_scenes(const std::vector<std::string>& paths,
                                             const std::string& directory) {
  std::set<std::string> files;
  Diagnostics problems;
  const auto keep = [&problems](const Result<Done>& result) {
    if (!result) problems.insert(problems.end(), result.diagnostics().begin(), result.diagnostics().end());
  };
  for (const std::string& path : paths) keep(add_path(path, files));
  if (paths.empty()) {
    const Result<Project> project = find_project(directory);
    if (!project) return project.diagnostics();
    keep(add_path(project->scenes, files));
  }
  if (!problems.empty()) return problems;
  return std::vector<std::string>(files.begin(), files.end());
}

bool matches_glob(std::string_view glob, std::string_view text) {
  constexpr std::size_t kNone = std::string_view::npos;
  std::size_t g = 0, t = 0, star = kNone, star_text = 0;
  while (t < text.size()) {
    if (g < glob.size() && glob[g] == '*') {
      star = g++;
      star_text = t;
    } else if (g < glob.size() && (glob[g] == '?' || glob[g] == text[t])) {
      ++g;
      ++t;
    } else if (star != kNone) {  // only the last "*" need ever take more: no exponential search
      g = star + 1;
      t = ++star_text;
    } else {
      return false;
    }
  }
  return glob.find_first_not_of('*', g) == kNone;
}

bool is_chosen(const std::vector<std::string>& filters, std::string_view id) {
  bool has_positive = false, chosen = false;
  for (const std::string& filter : filters) {
    const bool excludes = filter.starts_with('!');
    const bool matched = matches_glob(std::string_view(filter).substr(excludes ? 1 : 0), id);
    if (excludes && matched) return false;
    has_positive = has_positive || !excludes;
    chosen = chosen || (!excludes && matched);
  }
  return chosen || !has_positive;
}

Result<Shard> parse_shard(std::string_view text) {
  Shard shard;
  const char *begin = text.data(), *end = begin + text.size();
  const auto [slash, first] = std::from_chars(begin, end, shard.index);
  if (first == std::errc{} && slash != end && *slash == '/') {
    const auto [stop, second] = std::from_chars(slash + 1, end, shard.count);
    if (second == std::errc{} && stop == end && shard.index >= 1 && shard.index <= shard.count) return shard;
  }
  return Diagnostic{"", 0, 0,
                    "--shard expects I/N with 1 <= I <= N, such as 1/4, got \"" + std::string(text) + "\""};
}

}  // namespace gnomon::scene
