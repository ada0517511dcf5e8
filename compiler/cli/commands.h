// SPDX-License-Identifier: MIT
// The commands of gnomonc.
#pragma once

#include "cli/command_line.h"

namespace gnomon::cli {

/// Does what was asked for; messages go to standard error. The exit code.
[[nodiscard]] int run(const Command& command);

}  // namespace gnomon::cli
