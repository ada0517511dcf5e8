// SPDX-License-Identifier: MIT
// From a document of the right shape to a Scene: what the schema cannot say is checked here.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "scene/json.h"
#include "scene/load.h"
#include "scene/project.h"
#include "scene/report.h"

namespace gnomon::scene {

/// What every test of one scene file shares.
struct BuildContext {
  const Vocabulary& vocabulary;
  const Project& project;
  std::string file;  ///< the scene file, as given
};

/// The scene that `root` (every section of the right shape, or left out) describes, without id, golden file
/// and overrides. Mistakes go to `report`; what is returned counts only if there are none.
[[nodiscard]] Scene build_scene(const json::Value& root, const BuildContext& context, Report& report);

/// See check_size in load.h: messages by the JSON pointer they belong to.
struct SizeProblem {
  std::string pointer;
  std::string message;
};
[[nodiscard]] std::vector<SizeProblem> size_problems(const Scene& scene, std::array<int, 2> map_size);

/// The size of the scene's height map, where that is known without reading a file.
[[nodiscard]] std::optional<std::array<int, 2>> map_size(const Scene& scene, const Vocabulary& vocabulary);

}  // namespace gnomon::scene
