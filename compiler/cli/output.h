// SPDX-License-Identifier: MIT
// Where a command's result goes.
#pragma once

#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::cli {

/// Writes to standard output. Fails (kMachine) where not all of it arrives.
[[nodiscard]] Result<Done> print(const std::string& text);

/// Writes the text of a shader to `path`, which stays as it was on failure, or to standard output where it is
/// empty. Fails (kMachine) where that is not possible, (kInvalid) where `path` is one of the shader's own
/// sources.
[[nodiscard]] Result<Done> write(const compiler::Assembled& shader, const std::string& path);

}  // namespace gnomon::cli
