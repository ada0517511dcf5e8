// SPDX-License-Identifier: MIT
// Where the programs find the shader library at run time.
#pragma once

#include <string>

namespace gnomon {

/// The folder that <gnomon/...> names, for the program at `executable` (its path, or /proc/self/exe):
/// share/gnomon beside the program's bin folder where it is installed, else the source tree that the program
/// was built from. Where neither exists it is the installed place, so that a later error names it.
[[nodiscard]] std::string shader_library(const std::string& executable);

}  // namespace gnomon
