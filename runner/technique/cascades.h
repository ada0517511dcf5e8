// SPDX-License-Identifier: MIT
// Cascaded shadow maps: where each lies, and the mesh as the sun sees it.
#pragma once

#include <array>
#include <vector>

#include "gl/texture.h"
#include "gnomon/diagnostic.h"
#include "scene/scene.h"
#include "technique/ground.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"
#include "technique/tiles.h"

namespace gnomon::technique {

/// A square of the plane across the sun's direction.
struct CascadeSquare {
  glm::dvec2 corner;  ///< metres along the light's right and down
  double texel;       ///< metres a side
};

/// The squares for what a camera sees, finest first; at least one.
struct CascadeFit {
  glm::dvec3 origin{};  ///< metres, nearer to the sun than every point of the map
  glm::dvec3 right{};   ///< unit vectors
  glm::dvec3 down{};
  glm::dvec3 forward{};  ///< away from the sun
  double range = 1;      ///< metres along `forward` within which the map lies
  std::vector<CascadeSquare> squares{};
};

/// Fits them to the slices of a perspective or orthographic camera between the nearest and the farthest point
/// of `ground` (with their filter's margin), never larger than the whole map needs; other cameras get one for
/// the whole map. Zhang et al. 2006, eq. 6 for the slices.
[[nodiscard]] CascadeFit fit_cascades(const scene::Scene& scene, const Ground& ground,
                                      const Pyramid& pyramid);

/// Drawn maps, and what programs/light_pass.glsl takes.
struct CascadeMaps {
  gl::Texture nearness;  ///< kDepth32F, as host/light_nearness.glsl reads it
  Uniforms uniforms;
};

/// The program that draws them. Of maps without holes it discards nothing, which would be slower.
[[nodiscard]] Result<const CachedProgram*> depth_program(ProgramCache& programs, bool holes);

/// Fails where the maps are larger than the driver's textures. Adds the draws' time to `seconds`.
[[nodiscard]] Result<CascadeMaps> draw_cascades(ProgramCache& programs, const Pyramid& pyramid,
                                                const scene::Scene& scene, const Ground& ground,
                                                double& seconds);

}  // namespace gnomon::technique
