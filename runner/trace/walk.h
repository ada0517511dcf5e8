// SPDX-License-Identifier: MIT
// The walks of the methods, observed. Internal to this folder.
#pragma once

#include "trace/pixel_modules.h"
#include "trace/trace.h"

namespace gnomon::trace {

/// What a method is asked.
struct Question {
  Modules::GnomonReceiver receiver;
  glm::vec3 to_sun{};
};

/// multilevel or brute_force.
[[nodiscard]] Result<Walk> observe_walk(const PixelModules& modules, const Question& question,
                                        const std::string& method);
/// multilevel_literal.
[[nodiscard]] Result<Walk> observe_literal_walk(const PixelModules& modules, const Question& question);

/// The failure that a retold walk differs from the observed one at a step.
[[nodiscard]] Diagnostic retold_wrongly(std::size_t step);

}  // namespace gnomon::trace
