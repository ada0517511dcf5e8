// SPDX-License-Identifier: MIT
#include "gnomon/compiler/stage.h"

#include <algorithm>
#include <filesystem>

namespace gnomon::compiler {

const std::vector<StageName>& stages() {
  static const std::vector<StageName> table = {
      {Stage::kVertex, "vert", "vertex"},
      {Stage::kFragment, "frag", "fragment"},
      {Stage::kGeometry, "geom", "geometry"},
      {Stage::kCompute, "comp", "compute"},
  };
  return table;
}

const StageName& stage_name(Stage stage) {
  return *std::ranges::find(stages(), stage, &StageName::stage);
}

std::optional<Stage> stage_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const StageName& row : stages()) {
    if (extension == "." + row.name) return row.stage;
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
