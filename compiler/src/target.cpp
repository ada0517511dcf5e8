// SPDX-License-Identifier: MIT
#include <filesystem>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

const std::vector<Target>& targets() {
  static const std::vector<Target> table = {
      {"glsl450", "#version 450 core", "GLSL 4.50 for desktop OpenGL, as text"},
  };
  return table;
}

const std::vector<StageName>& stages() {
  static const std::vector<StageName> table = {
      {Stage::kVertex, "vert"},
      {Stage::kFragment, "frag"},
      {Stage::kGeometry, "geom"},
      {Stage::kCompute, "comp"},
  };
  return table;
}

std::optional<Stage> stage_of(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension().string();
  for (const StageName& row : stages()) {
    if (extension == "." + row.name) return row.stage;
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
