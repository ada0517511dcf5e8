// SPDX-License-Identifier: MIT
// What an output depends on, as build systems read it.
#pragma once

#include <string>
#include <vector>

namespace gnomon::compiler {

/// A rule for Make and Ninja: `target` depends on `files`, the main one first, and, as with gcc's -MP, an
/// empty rule for each of the others: a file that is gone makes the target out of date instead of stopping
/// Make. Blanks, '#', '$' and ':' are escaped; a path with a line break cannot be written so that they read
/// it.
[[nodiscard]] std::string to_depfile(const std::string& target, const std::vector<std::string>& files);

}  // namespace gnomon::compiler
