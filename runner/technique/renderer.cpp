// SPDX-License-Identifier: MIT
#include "technique/renderer.h"

#include <cmath>

#include "technique/sun.h"
#include "technique/technique.h"
#include "technique/tiles.h"

namespace gnomon::technique {
namespace {

constexpr float kUndecided = 0.0F;  // GNOMON_CAUSE_UNDECIDED

Uniforms shadow_uniforms(const Pyramid& pyramid, const scene::Scene& scene, const Ground& ground) {
  Uniforms uniforms = map_uniforms(pyramid);
  uniforms.emplace_back("u_texels_per_pixel", ground.texels_per_pixel);
  uniforms.emplace_back("u_level_scale", static_cast<float>(std::ldexp(1.0, -pyramid.q)));
  uniforms.emplace_back("u_receiver_height", static_cast<float>(scene.shadow.receiver_height));
  uniforms.emplace_back("u_to_sun", to_sun_single(scene.sun));
  uniforms.emplace_back("u_k", glm::vec2(scene.shadow.k_dark, scene.shadow.k_bright));
  return uniforms;
}

/// Whether any pixel of the tile asks for level q.
bool asks_for(const Ground& ground, const Tile& tile, int q) {
  for (int y = 0; y < tile.size.y; ++y) {
    for (int x = 0; x < tile.size.x; ++x) {
      const std::size_t i = ground.index(tile.first + glm::ivec2(x, y));
      if (ground.valid[i] != 0 && static_cast<int>(ground.q[i]) == q) return true;
    }
  }
  return false;
}

Diagnostic step_bound_reached(const scene::Scene& scene, int limit, glm::ivec2 pixel) {
  return {.file = scene.file,
          .message = "the ray of pixel (" + std::to_string(pixel.x) + ", " + std::to_string(pixel.y) +
                     ") reached the bound of " + std::to_string(limit) +
                     " steps undecided; this is a fault of the method '" + scene.shadow.method +
                     "', please report it with this scene",
          .failure = Failure::kFailed};
}

/// Copies what a draw of level q answered (b_shadow, k_shadow, steps, cause) into the image's channels.
Result<Done> store(const Texels& texels, const Tile& tile, const Ground& ground, const Pyramid& pyramid,
                   const scene::Scene& scene, image::Image& image) {
  std::vector<float>& b_shadow = image.channels["b_shadow"];
  std::vector<float>& k_shadow = image.channels["k_shadow"];
  std::vector<float>& steps = image.channels["steps"];
  for (int y = 0; y < tile.size.y; ++y) {
    for (int x = 0; x < tile.size.x; ++x) {
      const glm::ivec2 pixel = tile.first + glm::ivec2(x, y);
      const std::size_t i = ground.index(pixel);
      if (ground.valid[i] == 0 || static_cast<int>(ground.q[i]) != pyramid.q) continue;
      const float* texel = texels.at(x, y);
      if (texel[3] == kUndecided) return step_bound_reached(scene, step_limit(pyramid), pixel);
      b_shadow[i] = texel[0];
      k_shadow[i] = texel[1];
      steps[i] = texel[2];
    }
  }
  return Done{};
}

/// Answers the pixels that ask for the pyramid's level.
Result<Done> answer_level(const ShadowProgram& with, const Pyramid& pyramid, const scene::Scene& scene,
                          const Ground& ground, image::Image& image, double* seconds) {
  Uniforms uniforms = shadow_uniforms(pyramid, scene, ground);
  uniforms.insert(uniforms.end(), with.uniforms.begin(), with.uniforms.end());
  const bool is_map = ground.texels_per_pixel.x > 0;
  for (const Tile& tile : tiles_of(ground.size)) {
    if (!is_map && !asks_for(ground, tile, pyramid.q)) continue;
    std::vector<gl::Sampler> samplers = with.samplers;
    std::optional<gl::Texture> points;
    if (!is_map) {
      Result<gl::Texture> uploaded = upload_points(ground, tile, ground.q);
      if (!uploaded) return uploaded.diagnostics();
      points = std::move(uploaded).value();
      samplers.push_back({.name = "u_ground", .texture = &*points});
    }
    const Result<Texels> texels =
        draw_tile(tile, with.program->program, uniforms, std::move(samplers), with.buffers, seconds);
    if (!texels) return texels.diagnostics();
    if (const Result<Done> stored = store(*texels, tile, ground, pyramid, scene, image); !stored)
      return stored.diagnostics();
  }
  return Done{};
}

void tell_origin(const ShadowProgram& with, image::Image& image) {
  image.attributes["gnomon:shader_hash"] = with.program->shader_hash;
  image.attributes["gnomon:program_hash"] = with.program->program_hash;
}

void add_literal_extrema(const Pyramid& pyramid, ShadowProgram& with) {
  int levels = 0;
  if (pyramid.literal_extrema) {
    levels = pyramid.literal_extrema->levels();
    with.samplers.push_back(
        {.name = "gnomon_literal_extrema", .texture = &*pyramid.literal_extrema, .last_level = levels - 1});
  }
  with.uniforms.emplace_back("u_map_top_level", levels);  // in place of that of the block maxima
}

}  // namespace

Result<image::Image> render_shadow(ProgramCache& programs, const Pyramids& pyramids,
                                   const scene::Scene& scene, const Ground& ground, double* draw_seconds) {
  const Technique& technique = *find_technique(scene.shadow.method);
  const Result<const CachedProgram*> program = programs.get(technique.program);
  if (!program) return program.diagnostics();
  image::Image image = lit_image(ground);
  double seconds = 0;
  for (const auto& [q, pyramid] : pyramids) {
    ShadowProgram with{.program = *program, .samplers = map_samplers(*pyramid)};
    if (technique.bounds == Bounds::kLiteralExtrema) add_literal_extrema(*pyramid, with);
    const Result<Done> answered = answer_level(with, *pyramid, scene, ground, image, &seconds);
    if (!answered) return answered.diagnostics();
  }
  tell_origin({.program = *program, .samplers = {}}, image);
  if (draw_seconds) *draw_seconds = seconds;
  return image;
}

Result<image::Image> render_shadow_with(const ShadowProgram& with, const Pyramid& pyramid,
                                        const scene::Scene& scene, const Ground& ground,
                                        double* draw_seconds) {
  image::Image image = lit_image(ground);
  double seconds = 0;
  const Result<Done> answered = answer_level(with, pyramid, scene, ground, image, &seconds);
  if (!answered) return answered.diagnostics();
  tell_origin(with, image);
  if (draw_seconds) *draw_seconds = seconds;
  return image;
}

}  // namespace gnomon::technique
