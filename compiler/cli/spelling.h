// SPDX-License-Identifier: MIT
// Options spelt as compilers spell them, -MD and -MF FILE, which CLI11 would read as -M with the value D or
// F.
#pragma once

#include <string>
#include <vector>

namespace gnomon::cli {

/// The arguments after the program's name, with -MD, -MF FILE and -MFFILE turned into --MD, --MF FILE. What
/// follows a lone "--" stays as it is.
[[nodiscard]] std::vector<std::string> with_long_names(int argc, const char* const* argv);

/// `text` of --help or an error with the names as people type them.
[[nodiscard]] std::string with_typed_names(std::string text);

}  // namespace gnomon::cli
