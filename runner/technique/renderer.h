// SPDX-License-Identifier: MIT
// Renders the shadow of a scene's points with a shader method.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "gl/draw.h"
#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"
#include "technique/ground.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"

namespace gnomon::technique {

/// By their level q.
using Pyramids = std::map<int, const Pyramid*>;

/// A program that ends in programs/shadow_pass.glsl, and what its host functions read.
struct ShadowProgram {
  const CachedProgram* program = nullptr;
  std::vector<gl::Sampler> samplers;
  std::vector<gl::BufferInput> buffers{};
  std::vector<std::pair<std::string, gl::Uniform>> uniforms{};
};

/// Asks the scene's method for the shadow of every point of `ground`, from the pyramids of the levels that it
/// asks for. Channels b_shadow, k_shadow, q, steps, valid and, but for the map camera, column, row, depth.
/// Fails (kFailed) if a ray reached its step bound, naming the first such pixel. `draw_seconds`, where given,
/// takes the sum of the draws' times, without reading back.
[[nodiscard]] Result<image::Image> render_shadow(ProgramCache& programs, const Pyramids& pyramids,
                                                 const scene::Scene& scene, const Ground& ground,
                                                 double* draw_seconds = nullptr);

/// The same from one pyramid with a program of the caller's, whatever encoding its host functions read;
/// `pyramid` tells the numbers of the map.
[[nodiscard]] Result<image::Image> render_shadow_with(const ShadowProgram& with, const Pyramid& pyramid,
                                                      const scene::Scene& scene, const Ground& ground,
                                                      double* draw_seconds = nullptr);

}  // namespace gnomon::technique
