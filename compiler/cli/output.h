// SPDX-License-Identifier: MIT
// Where a command's result goes.
#pragma once

#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::cli {

/// Writes to standard output. Fails (kMachine) where not all of it arrives.
[[nodiscard]] Result<Done> print(const std::string& text);

/// Writes the output of a shader to `path`, which stays as it was on failure, or to standard output where it
/// is empty. Fails (kMachine) where that is not possible, (kInvalid) where `path` is one of the shader's own
/// sources, and for SPIR-V without a path.
[[nodiscard]] Result<Done> write(const compiler::Compiled& shader, const std::string& path);

/// Writes `text`, made of `shader`, to `path`. Fails as write() does.
[[nodiscard]] Result<Done> write_beside(const compiler::Compiled& shader, const std::string& text,
                                        const std::string& path);

}  // namespace gnomon::cli
