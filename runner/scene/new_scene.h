// SPDX-License-Identifier: MIT
// What `gnomon new NAME` writes: a described scene that passes, and what its project lacks.
#pragma once

#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::scene {

struct NewFile {
  std::string path;  ///< ready to open; its folder may not exist yet
  std::string text;
};

/// The files to write for a new scene NAME ("area/case") in the project around `directory`: the scene first,
/// then gnomon.json where there is none upwards, and the scene schema beside it where that is missing. Fails
/// for a name that is no relative path of letters, digits and `_ - . +`, and where the scene exists.
[[nodiscard]] Result<std::vector<NewFile>> new_scene(const std::string& name,
                                                     const std::string& directory = ".");

/// The scene itself; `schema` is the path of the schema relative to the scene's folder.
[[nodiscard]] std::string new_scene_text(const std::string& schema);

/// A gnomon.json with every default written out.
[[nodiscard]] std::string new_project_text();

}  // namespace gnomon::scene
