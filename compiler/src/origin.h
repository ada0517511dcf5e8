// SPDX-License-Identifier: MIT
// Failures at the original file and line.
#pragma once

#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// A failure (kFailed) at `origin`, the include chain in its notes. Needs `files` and `inclusions` only.
[[nodiscard]] Diagnostic failure_at(const Assembled& assembled, LineOrigin origin, std::string message);

/// The path of the file that an inclusion inlines.
[[nodiscard]] const std::string& file_of(const Assembled& assembled, int inclusion);

}  // namespace gnomon::compiler
