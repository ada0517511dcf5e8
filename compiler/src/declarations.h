// SPDX-License-Identifier: MIT
// Where the names of a text are declared, which glslang's tree does not tell of global ones.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "shader.h"

namespace gnomon::compiler {

/// The first uniform outside of blocks whose name an earlier global declaration of the text has taken. With
/// Vulkan's relaxed rules glslang crashes there, or takes both for one. `text` is preprocessed.
[[nodiscard]] std::optional<Message> find_uniform_collision(const std::string& text);

/// Lines of global declarations, read when the first is asked for. The text has to outlive it, and to
/// compile.
class DeclarationLines {
 public:
  DeclarationLines(const std::string& text, Stage stage, const Target& target)
      : text_(text), stage_(stage), target_(target) {}

  /// Of a variable, a structure, a block, or a member of a block without an instance name: its first
  /// declaration; of another name the first line that has it.
  [[nodiscard]] int of(const std::string& name);

 private:
  const std::string& text_;
  Stage stage_;
  const Target& target_;
  std::map<std::string, int> lines_;
};

}  // namespace gnomon::compiler
