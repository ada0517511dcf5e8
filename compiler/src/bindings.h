// SPDX-License-Identifier: MIT
// Numbers that two resources of a shader would share.
#pragma once

#include <optional>
#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// Whether the target has Vulkan's descriptor sets.
[[nodiscard]] bool has_descriptor_sets(const Target& target);

/// Two resources for which a target has one place only.
struct SharedBinding {
  std::string name;     ///< of the second of them
  std::string message;  ///< which place, whose it is, and what to do
};

/// The first such pair. Arrays take a place for each element.
[[nodiscard]] std::optional<SharedBinding> find_shared_binding(const Reflection& reflection,
                                                               const Target& target);

}  // namespace gnomon::compiler
