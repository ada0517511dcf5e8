// SPDX-License-Identifier: MIT
#include "technique/tiles.h"

#include <algorithm>
#include <chrono>

namespace gnomon::technique {

std::vector<Tile> tiles_of(glm::ivec2 image) {
  std::vector<Tile> tiles;
  for (int y = 0; y < image.y; y += kTile) {
    for (int x = 0; x < image.x; x += kTile) {
      tiles.push_back({{x, y}, glm::min(glm::ivec2(kTile), image - glm::ivec2(x, y))});
    }
  }
  return tiles;
}

int step_limit(glm::ivec2 samples) {
  return 8 * (samples.x + samples.y);
}

Uniforms map_uniforms(const Pyramid& pyramid) {
  return {{"u_map_size", pyramid.size},
          {"u_map_domain", pyramid.domain},
          {"u_map_spacing", pyramid.spacing},
          {"u_map_highest", pyramid.highest},
          {"u_map_top_level", pyramid.top_level()},
          {"u_q", pyramid.q},
          {"u_step_limit", step_limit(pyramid.size)}};
}

Uniforms camera_uniforms(const CameraRays& rays, glm::dvec2 offset) {
  return {{"u_eye", glm::vec3(rays.eye)},
          {"u_forward", glm::vec3(rays.forward)},
          {"u_right", glm::vec3(rays.right)},
          {"u_down", glm::vec3(rays.down)},
          {"u_middle", glm::vec2(rays.middle - offset)},
          {"u_perspective", rays.perspective ? 1 : 0}};
}

std::vector<gl::Sampler> map_samplers(const Pyramid& pyramid) {
  return {{.name = "gnomon_heights", .texture = &pyramid.heights},
          {.name = "gnomon_extrema", .texture = &pyramid.extrema, .last_level = pyramid.top_level() - 1}};
}

Result<gl::Texture> upload_points(const Ground& ground, const Tile& tile, const std::vector<float>& fourth) {
  std::vector<float> texels;
  texels.reserve(4 * static_cast<std::size_t>(tile.size.x) * static_cast<std::size_t>(tile.size.y));
  for (int y = 0; y < tile.size.y; ++y) {
    for (int x = 0; x < tile.size.x; ++x) {
      const std::size_t i = ground.index(tile.first + glm::ivec2(x, y));
      texels.insert(texels.end(), {ground.column[i], ground.row[i], ground.valid[i], fourth[i]});
    }
  }
  Result<gl::Texture> texture = gl::Texture::create(gl::Format::kRgba32F, {tile.size.x, tile.size.y});
  if (texture) texture->upload(texels);
  return texture;
}

Result<gl::Texture> answers_of(glm::ivec2 size) {
  return gl::Texture::create(gl::Format::kRgba32F, {size.x, size.y});
}

Result<Done> draw_timed(std::span<const gl::Pass> passes, double* seconds) {
  const auto begin = std::chrono::steady_clock::now();
  const Result<Done> drawn = gl::draw(passes);
  if (seconds) *seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return drawn;
}

Result<Texels> draw_tile(const Tile& tile, gl::Pass pass, double* seconds) {
  const Result<gl::Texture> target = answers_of(tile.size);
  if (!target) return target.diagnostics();
  pass.target = &*target;
  std::optional<gl::Texture> depth;
  if (pass.mesh) {
    Result<gl::Texture> made = gl::Texture::create(gl::Format::kDepth32F, {tile.size.x, tile.size.y});
    if (!made) return made.diagnostics();
    depth = std::move(made).value();
    pass.mesh->depth = &*depth;
  }
  pass.uniforms.emplace_back("u_first_pixel", glm::vec2(tile.first));
  pass.uniforms.emplace_back("u_tile_size", glm::vec2(tile.size));
  const Result<Done> drawn = draw_timed({&pass, 1}, seconds);
  if (!drawn) return drawn.diagnostics();
  return Texels{target->download(), tile.size.x};
}

}  // namespace gnomon::technique
