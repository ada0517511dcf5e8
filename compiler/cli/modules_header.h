// SPDX-License-Identifier: MIT
// The command `cpp`.
#pragma once

#include "cli/command_line.h"

namespace gnomon::cli {

/// Writes the command's modules as a C++ header to its output. Fails as compiler::cpp_header does, (kMachine)
/// where the output cannot be written.
[[nodiscard]] Result<Done> write_cpp(const Command& command);

}  // namespace gnomon::cli
