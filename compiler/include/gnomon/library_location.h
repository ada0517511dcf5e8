// SPDX-License-Identifier: MIT
// Where the programs find the shader library at run time.
#pragma once

#include <string>

namespace gnomon {

/// The folder that <gnomon/...> names, for the program at `executable` (its path, or /proc/self/exe): where
/// the installation puts it, seen from the program's folder, which is ../share/gnomon unless CMake was told
/// another CMAKE_INSTALL_BINDIR. For a program of the build tree: the source tree. An installed program never
/// falls back on that: where its library is missing, a later error names the installed place.
[[nodiscard]] std::string shader_library(const std::string& executable);

}  // namespace gnomon
