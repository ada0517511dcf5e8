// SPDX-License-Identifier: MIT
#include "technique/renderer.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "technique/cascades.h"
#include "technique/hash.h"
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

Diagnostic step_bound_reached(const scene::Scene& scene, int limit, std::size_t pixel, int image_width) {
  const auto width = static_cast<std::size_t>(image_width);
  return {.file = scene.file,
          .message = "the ray of pixel (" + std::to_string(pixel % width) + ", " +
                     std::to_string(pixel / width) + ") reached the bound of " + std::to_string(limit) +
                     " steps undecided; this is a fault of the method '" + scene.shadow.method +
                     "', please report it with this scene",
          .failure = Failure::kFailed};
}

/// What a draw answered for a pixel: b_shadow, k_shadow, steps, cause.
Result<Done> store(const float* answer, std::size_t pixel, const Pyramid& pyramid, const scene::Scene& scene,
                   image::Image& image) {
  if (answer[3] == kUndecided) return step_bound_reached(scene, step_limit(pyramid.size), pixel, image.width);
  image.channels["b_shadow"][pixel] = answer[0];
  image.channels["k_shadow"][pixel] = answer[1];
  image.channels["steps"][pixel] = answer[2];
  return Done{};
}

/// Pixels that are neighbours in the image are neighbours in a list too, where groups of its texels walk
/// together: squares of this side one after the other, in the list as in the image.
constexpr int kSquare = 8;

/// Pixels in the order of a list.
std::vector<std::size_t> by_squares(std::vector<std::size_t> pixels, int image_width) {
  const auto width = static_cast<std::size_t>(image_width);
  const auto square = [width](std::size_t pixel) {
    return std::pair(pixel / width / kSquare, pixel % width / kSquare);
  };
  std::stable_sort(pixels.begin(), pixels.end(),
                   [&](std::size_t a, std::size_t b) { return square(a) < square(b); });
  return pixels;
}

/// Texels of a list: whole squares, at most kTile a side.
glm::ivec2 list_size(std::size_t pixels) {
  const int squares = static_cast<int>((pixels + kSquare * kSquare - 1) / (kSquare * kSquare));
  const int columns = std::min(squares, kTile / kSquare);
  return glm::ivec2(columns, (squares + columns - 1) / columns) * kSquare;
}

/// The texel of a list's entry, as an index row by row.
std::size_t texel_of(std::size_t entry, glm::ivec2 size) {
  const std::size_t square = entry / (kSquare * kSquare), inside = entry % (kSquare * kSquare);
  const auto columns = static_cast<std::size_t>(size.x / kSquare);
  const std::size_t row = square / columns * kSquare + inside / kSquare;
  return row * static_cast<std::size_t>(size.x) + square % columns * kSquare + inside % kSquare;
}

/// The points of these pixels as a list.
Result<gl::Texture> upload(const Ground& ground, std::span<const std::size_t> pixels, glm::ivec2 size) {
  std::vector<float> texels(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const std::size_t texel = texel_of(i, size);
    texels[4 * texel] = ground.column[pixels[i]];
    texels[4 * texel + 1] = ground.row[pixels[i]];
  }
  Result<gl::Texture> texture = gl::Texture::create(gl::Format::kRgba32F, {size.x, size.y});
  if (texture) texture->upload(texels);
  return texture;
}

/// What every draw of one level takes.
struct Level {
  const ShadowProgram& with;
  const Pyramid& pyramid;
  const scene::Scene& scene;
  const Ground& ground;
  const Uniforms& uniforms;
};

/// Answers the map camera, whose points the program forms itself, tile by tile.
Result<Done> answer_tiles(const Level& level, image::Image& image, double* seconds) {
  for (const Tile& tile : tiles_of(level.ground.size)) {
    const Result<Texels> texels = draw_tile(tile, level.with.program->program, level.uniforms,
                                            level.with.samplers, level.with.buffers, seconds);
    if (!texels) return texels.diagnostics();
    for (int y = 0; y < tile.size.y; ++y) {
      for (int x = 0; x < tile.size.x; ++x) {
        const std::size_t pixel = level.ground.index(tile.first + glm::ivec2(x, y));
        if (level.ground.valid[pixel] == 0) continue;
        const Result<Done> stored = store(texels->at(x, y), pixel, level.pyramid, level.scene, image);
        if (!stored) return stored;
      }
    }
  }
  return Done{};
}

/// Answers the pixels that ask for the pyramid's level, as a list without gaps: where neighbours ask for
/// different levels, a draw over the image would walk for pixels that it does not answer.
Result<Done> answer_list(const Level& level, image::Image& image, double* seconds) {
  const std::vector<std::size_t> asking =
      by_squares(level.ground.asking(level.pyramid.q), level.ground.size.x);
  constexpr std::size_t kMost = std::size_t{kTile} * kTile;
  for (std::size_t first = 0; first < asking.size(); first += kMost) {
    const std::span pixels = std::span(asking).subspan(first, std::min(kMost, asking.size() - first));
    const glm::ivec2 size = list_size(pixels.size());
    const Result<gl::Texture> points = upload(level.ground, pixels, size);
    if (!points) return points.diagnostics();
    std::vector<gl::Sampler> samplers = level.with.samplers;
    samplers.push_back({.name = "u_points", .texture = &points.value()});
    const Result<Texels> texels = draw_tile({.first = {}, .size = size}, level.with.program->program,
                                            level.uniforms, std::move(samplers), level.with.buffers, seconds);
    if (!texels) return texels.diagnostics();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const Result<Done> stored =
          store(&texels->values[4 * texel_of(i, size)], pixels[i], level.pyramid, level.scene, image);
      if (!stored) return stored;
    }
  }
  return Done{};
}

Result<Done> answer_level(const ShadowProgram& with, const Pyramid& pyramid, const scene::Scene& scene,
                          const Ground& ground, image::Image& image, double* seconds) {
  Uniforms uniforms = shadow_uniforms(pyramid, scene, ground);
  uniforms.insert(uniforms.end(), with.uniforms.begin(), with.uniforms.end());
  const Level level{with, pyramid, scene, ground, uniforms};
  const bool is_map = ground.texels_per_pixel.x > 0;
  return is_map ? answer_tiles(level, image, seconds) : answer_list(level, image, seconds);
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

/// Answers one level by a program whose samplers are those of its pyramid.
Result<Done> answer_technique(ProgramCache& programs, const Technique& technique, ShadowProgram with,
                              const Pyramid& pyramid, const scene::Scene& scene, const Ground& ground,
                              image::Image& image, double* seconds) {
  if (technique.bounds == Bounds::kLiteralExtrema) add_literal_extrema(pyramid, with);
  if (technique.bounds != Bounds::kCascades)
    return answer_level(with, pyramid, scene, ground, image, seconds);
  Result<CascadeMaps> maps = draw_cascades(programs, pyramid, scene, ground, *seconds);
  if (!maps) return maps.diagnostics();
  with.samplers.push_back({.name = "gnomon_light_nearness", .texture = &maps->nearness});
  with.uniforms = std::move(maps->uniforms);
  return answer_level(with, pyramid, scene, ground, image, seconds);
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
    const Result<Done> answered =
        answer_technique(programs, technique, {.program = *program, .samplers = map_samplers(*pyramid)},
                         *pyramid, scene, ground, image, &seconds);
    if (!answered) return answered.diagnostics();
  }
  tell_origin({.program = *program, .samplers = {}}, image);
  if (technique.bounds == Bounds::kCascades) {
    const bool holes = !pyramids.empty() && pyramids.begin()->second->holes;
    const Result<const CachedProgram*> depth = depth_program(programs, holes);
    if (!depth) return depth.diagnostics();
    image.attributes["gnomon:program_hash"] = hash_text((*program)->program_hash + (*depth)->program_hash);
  }
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
