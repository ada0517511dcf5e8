// SPDX-License-Identifier: MIT
#include "technique/camera.h"
#include "technique/ground.h"
#include "technique/mesh.h"
#include "technique/tiles.h"
#include "terrain/level.h"

namespace gnomon::technique {
namespace {

// In place of a level of detail, as programs/view_pass.glsl writes them.
constexpr float kNothingSeen = -1.0F;
constexpr float kUndecided = -2.0F;

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

/// How a camera's surface is drawn: a ray a pixel, or a mesh.
struct View {
  const CachedProgram* program = nullptr;
  Uniforms uniforms{};
  std::optional<gl::Mesh> mesh{};
};

Result<View> view_of(ProgramCache& programs, const Pyramid& base, const scene::ViewCamera& camera,
                     const CameraRays& rays) {
  const Result<const CachedProgram*> program = camera.mesh
                                                   ? programs.get("programs/mesh.frag", "programs/mesh.vert")
                                                   : programs.get("programs/view.frag");
  if (!program) return program.diagnostics();
  if (!camera.mesh) return View{.program = *program};
  const auto faces = camera.mesh->cull_back_faces ? gl::Faces::kFront : gl::Faces::kAll;
  View view{.program = *program,
            .uniforms = mesh_uniforms(base, rays, camera.mesh->step),
            .mesh = grid_mesh(base, camera.mesh->step, faces)};
  view.mesh->background = {0, 0, 0, kNothingSeen};
  return view;
}

}  // namespace

Result<Ground> seen_ground(ProgramCache& programs, const Pyramid& base, const scene::ViewCamera& camera,
                           const scene::Shadow& shadow, glm::dvec2 offset, double* draw_seconds) {
  const CameraRays rays = camera_rays(camera);
  Result<View> view = view_of(programs, base, camera, rays);
  if (!view) return view.diagnostics();
  Ground ground = empty_ground({camera.size[0], camera.size[1]}, shadow);
  ground.depth.resize(ground.pixels());
  Uniforms uniforms = map_uniforms(base);
  for (auto& uniform : camera_uniforms(rays, offset)) uniforms.push_back(std::move(uniform));
  for (auto& uniform : view->uniforms) uniforms.push_back(std::move(uniform));
  uniforms.emplace_back("u_level", shadow.q.value_or(-1));
  uniforms.emplace_back("u_max_anisotropy", static_cast<float>(shadow.max_anisotropy));
  uniforms.emplace_back("u_coarsest", terrain::coarsest_level(base.size.x, base.size.y));
  const gl::Pass pass{.program = &view->program->program,
                      .uniforms = std::move(uniforms),
                      .samplers = map_samplers(base),
                      .mesh = view->mesh};
  for (const Tile& tile : tiles_of(ground.size)) {
    const Result<Texels> texels = draw_tile(tile, pass, draw_seconds);
    if (!texels) return texels.diagnostics();
    if (const Result<Done> stored = store(*texels, tile, ground); !stored) return stored.diagnostics();
  }
  return ground;
}

}  // namespace gnomon::technique
