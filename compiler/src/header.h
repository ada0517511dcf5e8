// SPDX-License-Identifier: MIT
// A compiled shader as a C++ header.
#pragma once

#include <string>
#include <vector>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// A C++17 header, self-contained: namespace gnomon_shaders::<name>, by default the name of the shader's
/// file, in it a namespace for each target with its output (`source`, or `spirv` as words) and its reflection
/// as constants.
[[nodiscard]] std::string header_text(const std::string& file, const std::string& name,
                                      const std::vector<Compiled>& embedded);

}  // namespace gnomon::compiler
