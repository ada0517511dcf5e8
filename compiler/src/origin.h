// SPDX-License-Identifier: MIT
// Original files and lines.
#pragma once

#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// A failure (kFailed) at `origin`, the include chain in its notes. Needs `files` and `inclusions` only.
[[nodiscard]] Diagnostic failure_at(const Assembled& assembled, LineOrigin origin, std::string message);

/// The path of the file that an inclusion inlines.
[[nodiscard]] const std::string& file_of(const Assembled& assembled, int inclusion);

/// A name for a file of the text that is the same on every machine: "gnomon/..." below the folder `library`,
/// else the path from the main file.
[[nodiscard]] std::string portable_name(const std::string& file, const Assembled& assembled,
                                        const std::string& library);

}  // namespace gnomon::compiler
