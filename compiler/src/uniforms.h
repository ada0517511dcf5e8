// SPDX-License-Identifier: MIT
// Declarations that glslang 12 does not survive.
#pragma once

#include <optional>
#include <string>

#include "shader.h"

namespace gnomon::compiler {

/// The first uniform outside of blocks whose name an earlier global declaration of the text has taken. With
/// Vulkan's relaxed rules glslang crashes there, or takes both for one. `text` is preprocessed.
[[nodiscard]] std::optional<Message> find_uniform_collision(const std::string& text);

}  // namespace gnomon::compiler
