// SPDX-License-Identifier: MIT
// The stages of a pipeline that a shader can be written for.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gnomon::compiler {

enum class Stage { kVertex, kFragment, kGeometry, kCompute };

/// A stage and how people name it. A new stage is one row of the table in src/stage.cpp.
struct StageName {
  Stage stage;
  std::string name;   ///< "frag": the value of --stage and, after a dot, the file's extension
  std::string title;  ///< "fragment"
};
[[nodiscard]] const std::vector<StageName>& stages();

/// The row of a stage.
[[nodiscard]] const StageName& stage_name(Stage stage);

/// The stage by extension (.vert .frag .geom .comp), none for other files.
[[nodiscard]] std::optional<Stage> stage_of(const std::string& path);

}  // namespace gnomon::compiler
