// SPDX-License-Identifier: MIT
// Targets that there are not, and what one refuses and others take.
#pragma once

#include <string>
#include <vector>

#include "attempt.h"

namespace gnomon::compiler {

/// "glsl450, essl310 and vulkan"; "no target" for none.
[[nodiscard]] std::string join(const std::vector<std::string>& names);

/// The failure of asking for a target that there is not.
[[nodiscard]] Diagnostic unknown_target(const std::string& name);

/// The diagnostic of a refusal. Where it is the target that lacks something, it names the targets that take
/// the shader, as far as they were seen to: each of them is tried.
[[nodiscard]] Diagnostic explain(const Request& request, const Target& target, const Refusal& refusal);

}  // namespace gnomon::compiler
