// SPDX-License-Identifier: MIT
#include "technique/renderer.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "technique/technique.h"
#include "technique/view.h"

namespace gnomon::technique {
namespace {

/// Pixels a side that one draw covers: a hardware driver resets a context whose draw takes seconds, and a
/// target for a whole 16384 x 16384 view would not fit in software GL.
constexpr int kTile = 1024;

constexpr float kUndecided = 0.0F;  // GNOMON_CAUSE_UNDECIDED

struct Tile {
  int x, y, width, height;
};

using Uniforms = std::vector<std::pair<std::string, gl::Uniform>>;

int step_limit(const Pyramid& pyramid) {
  return 8 * (pyramid.size.x + pyramid.size.y);
}

Uniforms uniforms_of(const Pyramid& pyramid, const scene::Scene& scene, const MapView& view) {
  const auto level_scale = static_cast<float>(std::ldexp(1.0, -pyramid.q));
  return {{"u_map_size", pyramid.size},
          {"u_map_domain", pyramid.domain},
          {"u_map_spacing", pyramid.spacing},
          {"u_map_highest", pyramid.highest},
          {"u_map_top_level", pyramid.top_level()},
          {"u_texels_per_pixel", view.texels_per_pixel * level_scale},
          {"u_receiver_height", static_cast<float>(scene.shadow.receiver_height)},
          {"u_to_sun", to_sun_single(scene.sun)},
          {"u_k", glm::vec2(scene.shadow.k_dark, scene.shadow.k_bright)},
          {"u_q", pyramid.q},
          {"u_step_limit", step_limit(pyramid)}};
}

image::Image empty_image(const MapView& view, int q) {
  image::Image image{.width = view.size.x, .height = view.size.y, .channels = {}, .attributes = {}};
  for (const char* name : {"b_shadow", "k_shadow", "steps"}) image.channels[name].resize(image.pixels());
  image.channels["q"].assign(image.pixels(), static_cast<float>(q));
  image.channels["valid"].assign(image.pixels(), 1.0F);
  return image;
}

Diagnostic step_bound_reached(const scene::Scene& scene, int limit, int x, int y) {
  return {.file = scene.file,
          .message = "the ray of pixel (" + std::to_string(x) + ", " + std::to_string(y) +
                     ") reached the bound of " + std::to_string(limit) +
                     " steps undecided; this is a fault of the method '" + scene.shadow.method +
                     "', please report it with this scene",
          .failure = Failure::kFailed};
}

/// Copies a tile's texels (b_shadow, k_shadow, steps, cause) into the image's channels.
Result<Done> store(const std::vector<float>& texels, int stride, const Tile& tile, const scene::Scene& scene,
                   int limit, image::Image& image) {
  std::vector<float>& b_shadow = image.channels["b_shadow"];
  std::vector<float>& k_shadow = image.channels["k_shadow"];
  std::vector<float>& steps = image.channels["steps"];
  for (int y = 0; y < tile.height; ++y) {
    for (int x = 0; x < tile.width; ++x) {
      const float* texel = &texels[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(stride) +
                                        static_cast<std::size_t>(x))];
      if (texel[3] == kUndecided) return step_bound_reached(scene, limit, tile.x + x, tile.y + y);
      const std::size_t pixel = static_cast<std::size_t>(tile.y + y) * static_cast<std::size_t>(image.width) +
                                static_cast<std::size_t>(tile.x + x);
      b_shadow[pixel] = texel[0];
      k_shadow[pixel] = texel[1];
      steps[pixel] = texel[2];
    }
  }
  return Done{};
}

std::vector<Tile> tiles_of(glm::ivec2 size, int side) {
  std::vector<Tile> tiles;
  for (int y = 0; y < size.y; y += side) {
    for (int x = 0; x < size.x; x += side) {
      tiles.push_back({x, y, std::min(side, size.x - x), std::min(side, size.y - y)});
    }
  }
  return tiles;
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

Result<image::Image> render_shadow(ProgramCache& programs, const Pyramid& pyramid, const scene::Scene& scene,
                                   const terrain::HeightMap& base, double* draw_seconds) {
  const Technique& technique = *find_technique(scene.shadow.method);
  const Result<const CachedProgram*> program = programs.get(technique.program);
  if (!program) return program.diagnostics();
  ShadowProgram with{
      .program = *program,
      .samplers = {
          {.name = "gnomon_heights", .texture = &pyramid.heights},
          {.name = "gnomon_extrema", .texture = &pyramid.extrema, .last_level = pyramid.top_level() - 1}}};
  if (technique.bounds == Bounds::kLiteralExtrema) add_literal_extrema(pyramid, with);
  return render_shadow_with(with, pyramid, scene, base, draw_seconds);
}

Result<image::Image> render_shadow_with(const ShadowProgram& with, const Pyramid& pyramid,
                                        const scene::Scene& scene, const terrain::HeightMap& base,
                                        double* draw_seconds) {
  const MapView view = map_view(scene.camera, base);
  const gl::Size tile_size{std::min(kTile, view.size.x), std::min(kTile, view.size.y)};
  const Result<gl::Texture> target = gl::Texture::create(gl::Format::kRgba32F, tile_size);
  if (!target) return target.diagnostics();

  image::Image image = empty_image(view, pyramid.q);
  image.attributes["gnomon:shader_hash"] = with.program->shader_hash;
  image.attributes["gnomon:program_hash"] = with.program->program_hash;
  double seconds = 0;
  for (const Tile& tile : tiles_of(view.size, kTile)) {
    Uniforms uniforms = uniforms_of(pyramid, scene, view);
    uniforms.emplace_back("u_first_pixel", glm::vec2(tile.x, tile.y));
    uniforms.insert(uniforms.end(), with.uniforms.begin(), with.uniforms.end());
    const auto begin = std::chrono::steady_clock::now();
    const Result<Done> drawn = gl::draw({.program = &with.program->program,
                                         .uniforms = std::move(uniforms),
                                         .samplers = with.samplers,
                                         .buffers = with.buffers,
                                         .target = &target.value()});
    seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!drawn) return drawn.diagnostics();
    const Result<Done> stored =
        store(target->download(), tile_size.width, tile, scene, step_limit(pyramid), image);
    if (!stored) return stored.diagnostics();
  }
  if (draw_seconds) *draw_seconds = seconds;
  return image;
}

}  // namespace gnomon::technique
