// SPDX-License-Identifier: MIT
// What a shader is made of: the depfile of `build`, and `graph`.
#pragma once

#include <string>

#include "cli/command_line.h"

namespace gnomon::cli {

/// Writes the depfile of a `build` whose shader does not compile, where one was asked for. Fails (kMachine)
/// where it cannot be written, (kInvalid) where it would replace a source of the shader.
[[nodiscard]] Result<Done> write_depfile(const Command& command);

/// The include graph as text. Fails as compiler::assemble does.
[[nodiscard]] Result<std::string> graph_text(const Command& command);

}  // namespace gnomon::cli
