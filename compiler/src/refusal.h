// SPDX-License-Identifier: MIT
// Targets that there are not, and what one refuses and others take.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// "glsl450, essl310 and vulkan"; "no target" for none.
[[nodiscard]] std::string join(const std::vector<std::string>& names);

/// The failure of asking for a target that there is not.
[[nodiscard]] Diagnostic unknown_target(const std::string& name);

/// The names of the targets, other than `refusing` and those that only hold others, for which `takes` holds.
[[nodiscard]] std::vector<std::string> targets_that_take(const Target& refusing,
                                                         const std::function<bool(const Target&)>& takes);

}  // namespace gnomon::compiler
