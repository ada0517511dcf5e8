// SPDX-License-Identifier: MIT
// Texts that a person may paste into a shell.
#pragma once

#include <string>

namespace gnomon {

/// `text` as one word of a POSIX shell: as it is where that is safe, else in single quotes.
[[nodiscard]] std::string quote(const std::string& text);

}  // namespace gnomon
