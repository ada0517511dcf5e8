// SPDX-License-Identifier: MIT
// Locations and bindings that the source leaves open.
#pragma once

#include <optional>
#include <vector>

#include "bindings.h"
#include "declarations.h"
#include "resource.h"

namespace glslang {
class TIntermediate;
class TType;
}  // namespace glslang

namespace gnomon::compiler {

struct Numbered {
  std::vector<Resource> resources;   ///< that main() reaches, in the order of the text
  int outputs = 0;                   ///< of a fragment shader: its highest location and one
  std::optional<Message> objection;  ///< two at one location, or none left
};

/// Numbers, in the tree of a text that is not linked, what the target wants numbered and the source does not:
/// vertex inputs, fragment outputs, uniforms of OpenGL's SPIR-V, resources. In the order of the text, what
/// main() reaches first, around the numbers that the source gives. glslang would do it without regard for
/// those, and for what arrays and structures take.
[[nodiscard]] Numbered number(glslang::TIntermediate& code, Stage stage, const Target& target,
                              DeclarationLines& lines);

/// Locations that a uniform takes: one for each element of all its arrays and structures.
[[nodiscard]] double uniform_locations(const glslang::TType& type);

}  // namespace gnomon::compiler
