// SPDX-License-Identifier: MIT
// Where a command's result goes.
#pragma once

#include <string>

#include "cli/command_line.h"

namespace gnomon::cli {

/// Writes to standard output. Fails (kMachine) where not all of it arrives.
[[nodiscard]] Result<Done> print(const std::string& text);

/// Writes the output of a shader to the command's output, or to standard output where it has none, and its
/// reflection where the command asks for it. Fails (kMachine) where that is not possible, (kInvalid) where a
/// file is one of the shader's own sources, and for SPIR-V without a file; what was written before then
/// stays.
[[nodiscard]] Result<Done> write(const compiler::Compiled& shader, const Command& command);

}  // namespace gnomon::cli
