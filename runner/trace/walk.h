// SPDX-License-Identifier: MIT
// The walks of the methods, observed. Internal to this folder.
#pragma once

#include <utility>
#include <vector>

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

/// The walk with its steps, as a story tells them; it has to tell as many as were counted.
template <class Story>
[[nodiscard]] Result<Walk> told(Walk walk, Story& story) {
  walk.height = story.start_height();
  Result<std::vector<Step>> steps = story.tell();
  if (!steps) return steps.diagnostics();
  walk.steps = std::move(steps).value();
  if (walk.steps.size() != static_cast<std::size_t>(walk.count)) return retold_wrongly(walk.steps.size());
  return walk;
}

}  // namespace gnomon::trace
