// SPDX-License-Identifier: MIT
// Passes: a program, its inputs, and the part of a texture level that it fills, with every pixel or with a
// mesh.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace gnomon::gl {

using Uniform = std::variant<int, float, glm::ivec2, glm::vec2, glm::vec3>;

/// A texture as a sampler sees it: only the mip levels first_level..last_level.
struct Sampler {
  std::string name;
  const Texture* texture = nullptr;
  int first_level = 0;
  int last_level = 0;
};

/// A buffer as the program sees it: the storage block or the samplerBuffer of this name.
struct BufferInput {
  std::string name;
  const Buffer* buffer = nullptr;
};

enum class Faces { kAll, kFront, kBack };

/// A grid of triangles, drawn as instances of one strip each: the program places vertex gl_VertexID of strip
/// gl_InstanceID, counted from node u_first_node, whose even vertices lie on the strip's first side. The
/// nearest has the greatest depth; windows grow downward, so that triangles which turn clockwise there are
/// the front ones.
struct Mesh {
  /// A rectangle of the grid.
  struct Part {
    glm::ivec2 first{};  ///< node
    glm::ivec2 cells{};
  };
  std::vector<Part> parts{};
  Faces faces = Faces::kAll;       ///< that are drawn
  const Texture* depth = nullptr;  ///< kDepth32F; cleared in the window before
  glm::vec4 background{};          ///< colour where no triangle lies
};

/// A part of a target, texels.
struct Window {
  glm::ivec2 first{};
  glm::ivec2 size{};
};

struct Pass {
  const Program* program = nullptr;
  std::vector<std::pair<std::string, Uniform>> uniforms;  ///< a name that the program does not use is ignored
  std::vector<Sampler> samplers;                          ///< likewise
  std::vector<BufferInput> buffers{};                     ///< likewise
  const Texture* target = nullptr;                        ///< null: only depth is drawn
  int target_level = 0;
  std::optional<Window> window{};  ///< absent: the whole target
  std::optional<Mesh> mesh{};      ///< instead of every pixel of the window
};

/// Draws passes one after the other, all into the target (and depth) of the first, and waits until they are
/// drawn. Long images are drawn in tiles: a hardware driver resets a context whose single draw takes seconds.
/// Fails with kMachine on any GL error.
[[nodiscard]] Result<Done> draw(std::span<const Pass> passes);
[[nodiscard]] inline Result<Done> draw(const Pass& pass) {
  return draw(std::span(&pass, 1));
}

}  // namespace gnomon::gl
