// SPDX-License-Identifier: MIT
// Renders a scene's shadow with a shader method.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gl/draw.h"
#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// A program that ends in programs/shadow_pass.glsl, and what its host functions read.
struct ShadowProgram {
  const CachedProgram* program = nullptr;
  std::vector<gl::Sampler> samplers;
  std::vector<gl::BufferInput> buffers{};
  std::vector<std::pair<std::string, gl::Uniform>> uniforms{};
};

/// Draws the scene's view with the scene's method from a pyramid of level scene.shadow.q. Channels b_shadow,
/// k_shadow, q, steps, valid. Fails (kFailed) if a ray reached its step bound, naming the first such pixel.
/// `draw_seconds`, where given, takes the sum of the draws' times, without reading back.
[[nodiscard]] Result<image::Image> render_shadow(ProgramCache& programs, const Pyramid& pyramid,
                                                 const scene::Scene& scene, const terrain::HeightMap& base,
                                                 double* draw_seconds = nullptr);

/// The same with a program of the caller's, whatever encoding its host functions read; `pyramid` tells the
/// numbers of the map.
[[nodiscard]] Result<image::Image> render_shadow_with(const ShadowProgram& with, const Pyramid& pyramid,
                                                      const scene::Scene& scene,
                                                      const terrain::HeightMap& base,
                                                      double* draw_seconds = nullptr);

}  // namespace gnomon::technique
