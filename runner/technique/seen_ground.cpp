// SPDX-License-Identifier: MIT
#include "technique/camera.h"
#include "technique/ground.h"
#include "technique/tiles.h"
#include "terrain/level.h"

namespace gnomon::technique {
namespace {

// In place of a level of detail, as programs/view.frag writes them.
constexpr float kNothingSeen = -1.0F;
constexpr float kUndecided = -2.0F;

Uniforms camera_uniforms(const CameraRays& rays, glm::dvec2 offset) {
  return {{"u_eye", glm::vec3(rays.eye)},
          {"u_forward", glm::vec3(rays.forward)},
          {"u_right", glm::vec3(rays.right)},
          {"u_down", glm::vec3(rays.down)},
          {"u_middle", glm::vec2(rays.middle - offset)},
          {"u_perspective", rays.perspective ? 1 : 0}};
}

Diagnostic step_bound_reached(glm::ivec2 pixel) {
  return {.message = "the view ray of pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) +
                     ") reached its bound of steps; this is a fault of gnomon, please report it with this "
                     "scene",
          .failure = Failure::kFailed};
}

/// Copies a tile's column, row and depth.
Result<Done> store(const Texels& texels, const Tile& tile, Ground& ground) {
  for (int y = 0; y < tile.size.y; ++y) {
    for (int x = 0; x < tile.size.x; ++x) {
      const float* texel = texels.at(x, y);
      const glm::ivec2 pixel = tile.first + glm::ivec2(x, y);
      if (texel[3] == kUndecided) return step_bound_reached(pixel);
      const std::size_t i = ground.index(pixel);
      ground.column[i] = texel[0];
      ground.row[i] = texel[1];
      ground.depth[i] = texel[2];
      if (texel[3] == kNothingSeen) continue;
      ground.valid[i] = 1.0F;
      ground.q[i] = texel[3];
    }
  }
  return Done{};
}

}  // namespace

Result<Ground> seen_ground(ProgramCache& programs, const Pyramid& base, const scene::ViewCamera& camera,
                           const scene::Shadow& shadow, glm::dvec2 offset, double* draw_seconds) {
  const Result<const CachedProgram*> program = programs.get("programs/view.frag");
  if (!program) return program.diagnostics();
  Ground ground = empty_ground({camera.size[0], camera.size[1]}, shadow);
  ground.depth.resize(ground.pixels());
  Uniforms uniforms = map_uniforms(base);
  for (auto& uniform : camera_uniforms(camera_rays(camera), offset)) uniforms.push_back(std::move(uniform));
  uniforms.emplace_back("u_level", shadow.q.value_or(-1));
  uniforms.emplace_back("u_max_anisotropy", static_cast<float>(shadow.max_anisotropy));
  uniforms.emplace_back("u_coarsest", terrain::coarsest_level(base.size.x, base.size.y));
  for (const Tile& tile : tiles_of(ground.size)) {
    const Result<Texels> texels =
        draw_tile(tile, (*program)->program, uniforms, map_samplers(base), {}, draw_seconds);
    if (!texels) return texels.diagnostics();
    if (const Result<Done> stored = store(*texels, tile, ground); !stored) return stored.diagnostics();
  }
  return ground;
}

}  // namespace gnomon::technique
