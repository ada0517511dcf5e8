// SPDX-License-Identifier: MIT
// Several files as one text.
#pragma once

#include <string>
#include <vector>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// Like assemble(), of a text that includes each of `paths` in turn. It stands for the main file, without a
/// name.
[[nodiscard]] Result<Assembled> assemble_all(const std::vector<std::string>& paths, const Options& options);

}  // namespace gnomon::compiler
