// SPDX-License-Identifier: MIT
// One full-screen pass: a program, its inputs, and the texture level it fills.
#pragma once

#include <glm/glm.hpp>
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

struct Pass {
  const Program* program = nullptr;
  std::vector<std::pair<std::string, Uniform>> uniforms;  ///< a name that the program does not use is ignored
  std::vector<Sampler> samplers;                          ///< likewise
  std::vector<BufferInput> buffers{};                     ///< likewise
  const Texture* target = nullptr;
  int target_level = 0;
};

/// Draws every pixel of the target and waits until it is drawn. Long images are drawn in tiles: a hardware
/// driver resets a context whose single draw takes seconds. Fails with kMachine on any GL error.
[[nodiscard]] Result<Done> draw(const Pass& pass);

}  // namespace gnomon::gl
