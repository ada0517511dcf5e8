// SPDX-License-Identifier: MIT
// The project that a scene belongs to: its root, and where its scenes and goldens lie.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::scene {

inline constexpr const char* kProjectFile = "gnomon.json";

/// All paths are ready to open: relative to the working directory where the scene's path was, else absolute.
struct Project {
  std::string root;     ///< nearest folder upwards that holds a gnomon.json, else the scene's folder
  std::string scenes;   ///< folder of the scene files
  std::string goldens;  ///< folder of the golden images
  std::vector<std::string> includes;  ///< further folders in which shaders find their includes
  bool has_file = false;              ///< whether there is a gnomon.json
};

/// The project of a scene file or of a folder, which need not exist. Fails where the gnomon.json is
/// unreadable or invalid, every error located in it.
[[nodiscard]] Result<Project> find_project(const std::string& scene_or_directory);

/// The path of a scene file below the project's scenes, else below its root, without the extension; with "/".
[[nodiscard]] std::string test_id(const Project& project, const std::string& scene_file);

/// Where the golden image of a test lies, whether or not it exists.
[[nodiscard]] std::string golden_file(const Project& project, const std::string& test_id);

/// A file named inside a scene.
struct InsideFile {
  std::string path;        ///< ready to open
  std::string below_root;  ///< relative to the project's root, with "/": the same on every machine
};

/// Resolves `name` against `directory`. The message says why not: absolute, leading out of the root (by ".."
/// or a symbolic link; whether anything lies there is not said), missing, not a file.
[[nodiscard]] Result<InsideFile> resolve_inside(const Project& project, const std::string& directory,
                                                const std::string& name);

/// The bytes of a text file of at most 64 MiB. Fails (the file as a whole) if it is missing, no file, or
/// unreadable.
[[nodiscard]] Result<std::string> read_text(const std::string& path);

}  // namespace gnomon::scene
