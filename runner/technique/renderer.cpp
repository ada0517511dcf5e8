// SPDX-License-Identifier: MIT
#include "technique/renderer.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "technique/cascades.h"
#include "technique/hash.h"
#include "technique/point_list.h"
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

/// Where answers go.
struct Answers {
  const scene::Scene& scene;
  const Ground& ground;
  image::Image& image;
  double seconds = 0;  ///< of the draws
};

/// What a draw answered for a pixel: b_shadow, k_shadow, steps, cause.
Result<Done> store(const float* answer, std::size_t pixel, const Pyramid& pyramid, Answers& answers) {
  image::Image& image = answers.image;
  if (answer[3] == kUndecided)
    return step_bound_reached(answers.scene, step_limit(pyramid.size), pixel, image.width);
  image.channels["b_shadow"][pixel] = answer[0];
  image.channels["k_shadow"][pixel] = answer[1];
  image.channels["steps"][pixel] = answer[2];
  return Done{};
}

/// A level, and what its draws take.
struct Level {
  const Pyramid& pyramid;
  ShadowProgram with;  ///< with the level's uniforms
};

gl::Pass pass_of(const Level& level) {
  return {.program = &level.with.program->program,
          .uniforms = level.with.uniforms,
          .samplers = level.with.samplers,
          .buffers = level.with.buffers};
}

/// Answers the map camera, whose points the program forms itself, tile by tile.
Result<Done> answer_tiles(const Level& level, Answers& answers) {
  for (const Tile& tile : tiles_of(answers.ground.size)) {
    const Result<Texels> texels = draw_tile(tile, pass_of(level), &answers.seconds);
    if (!texels) return texels.diagnostics();
    for (int y = 0; y < tile.size.y; ++y) {
      for (int x = 0; x < tile.size.x; ++x) {
        const std::size_t pixel = answers.ground.index(tile.first + glm::ivec2(x, y));
        if (answers.ground.valid[pixel] == 0) continue;
        const Result<Done> stored = store(texels->at(x, y), pixel, level.pyramid, answers);
        if (!stored) return stored;
      }
    }
  }
  return Done{};
}

Result<gl::Texture> upload(const PointList& list, const Ground& ground) {
  const glm::ivec2 size = size_of(list);
  std::vector<float> texels(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  for (const Band& band : list) {
    for (std::size_t i = 0; i < band.pixels.size(); ++i) {
      const glm::ivec2 at = band.texel(i);
      float* texel = &texels[4 * static_cast<std::size_t>(at.y * size.x + at.x)];
      texel[0] = ground.column[band.pixels[i]];
      texel[1] = ground.row[band.pixels[i]];
    }
  }
  Result<gl::Texture> texture = answers_of(size);
  if (texture) texture->upload(texels);
  return texture;
}

using Levels = std::map<int, Level>;

Result<Done> store(const PointList& list, const Texels& texels, const Levels& levels, Answers& answers) {
  for (const Band& band : list) {
    const Pyramid& pyramid = levels.at(band.q).pyramid;
    for (std::size_t i = 0; i < band.pixels.size(); ++i) {
      const glm::ivec2 at = band.texel(i);
      const Result<Done> stored = store(texels.at(at.x, at.y), band.pixels[i], pyramid, answers);
      if (!stored) return stored;
    }
  }
  return Done{};
}

/// Answers the points of other cameras as lists, all levels in one go: where neighbours ask for different
/// levels, draws over the image would walk for pixels that they do not answer.
Result<Done> answer_lists(const Levels& levels, Answers& answers) {
  std::set<int> asked;
  for (const auto& [q, level] : levels) asked.insert(q);
  for (const PointList& list : point_lists(answers.ground, asked)) {
    const Result<gl::Texture> points = upload(list, answers.ground);
    if (!points) return points.diagnostics();
    const Result<gl::Texture> target = answers_of(size_of(list));
    if (!target) return target.diagnostics();
    std::vector<gl::Pass> passes;
    for (const Band& band : list) {
      passes.push_back(pass_of(levels.at(band.q)));
      passes.back().samplers.push_back({.name = "u_points", .texture = &*points});
      passes.back().target = &*target;
      passes.back().window = band.window;
    }
    if (const Result<Done> drawn = draw_timed(passes, &answers.seconds); !drawn) return drawn;
    const Result<Done> stored = store(list, {target->download(), target->size().width}, levels, answers);
    if (!stored) return stored;
  }
  return Done{};
}

Result<Done> answer(const Levels& levels, Answers& answers) {
  const bool is_map = answers.ground.texels_per_pixel.x > 0;
  if (!is_map) return answer_lists(levels, answers);
  for (const auto& [q, level] : levels) {
    if (const Result<Done> answered = answer_tiles(level, answers); !answered) return answered;
  }
  return Done{};
}

Level level_of(ShadowProgram with, const Pyramid& pyramid, const Answers& answers) {
  Uniforms uniforms = shadow_uniforms(pyramid, answers.scene, answers.ground);
  // Later ones stand: a method's own count of levels, in place of that of the block maxima.
  uniforms.insert(uniforms.end(), with.uniforms.begin(), with.uniforms.end());
  with.uniforms = std::move(uniforms);
  return {pyramid, std::move(with)};
}

void tell_origin(const CachedProgram& program, image::Image& image) {
  image.attributes["gnomon:shader_hash"] = program.shader_hash;
  image.attributes["gnomon:program_hash"] = program.program_hash;
}

void add_literal_extrema(const Pyramid& pyramid, ShadowProgram& with) {
  int levels = 0;
  if (pyramid.literal_extrema) {
    levels = pyramid.literal_extrema->levels();
    with.samplers.push_back(
        {.name = "gnomon_literal_extrema", .texture = &*pyramid.literal_extrema, .last_level = levels - 1});
  }
  with.uniforms.emplace_back("u_map_top_level", levels);
}

/// Each level's cascades are drawn from its own mesh, and live no longer than its answers: they are large.
Result<Done> answer_cascades(ProgramCache& programs, const Levels& levels, Answers& answers) {
  for (const auto& [q, level] : levels) {
    Result<CascadeMaps> maps =
        draw_cascades(programs, level.pyramid, answers.scene, answers.ground, answers.seconds);
    if (!maps) return maps.diagnostics();
    Level lit = level;
    lit.with.samplers.push_back({.name = "gnomon_light_nearness", .texture = &maps->nearness});
    lit.with.uniforms.insert(lit.with.uniforms.end(), maps->uniforms.begin(), maps->uniforms.end());
    if (const Result<Done> answered = answer({{q, lit}}, answers); !answered) return answered;
  }
  return Done{};
}

Result<Done> answer_technique(ProgramCache& programs, const Technique& technique,
                              const CachedProgram& program, const Pyramids& pyramids, Answers& answers) {
  Levels levels;
  for (const auto& [q, pyramid] : pyramids) {
    ShadowProgram with{.program = &program, .samplers = map_samplers(*pyramid)};
    if (technique.bounds == Bounds::kLiteralExtrema) add_literal_extrema(*pyramid, with);
    levels.emplace(q, level_of(std::move(with), *pyramid, answers));
  }
  return technique.bounds == Bounds::kCascades ? answer_cascades(programs, levels, answers)
                                               : answer(levels, answers);
}

}  // namespace

Result<image::Image> render_shadow(ProgramCache& programs, const Pyramids& pyramids,
                                   const scene::Scene& scene, const Ground& ground, double* draw_seconds) {
  const Technique& technique = *find_technique(scene.shadow.method);
  const Result<const CachedProgram*> program = programs.get(technique.program);
  if (!program) return program.diagnostics();
  image::Image image = lit_image(ground);
  Answers answers{scene, ground, image};
  const Result<Done> answered = answer_technique(programs, technique, **program, pyramids, answers);
  if (!answered) return answered.diagnostics();
  tell_origin(**program, image);
  if (technique.bounds == Bounds::kCascades) {
    const bool holes = !pyramids.empty() && pyramids.begin()->second->holes;
    const Result<const CachedProgram*> depth = depth_program(programs, holes);
    if (!depth) return depth.diagnostics();
    image.attributes["gnomon:program_hash"] = hash_text((*program)->program_hash + (*depth)->program_hash);
  }
  if (draw_seconds) *draw_seconds = answers.seconds;
  return image;
}

Result<image::Image> render_shadow_with(const ShadowProgram& with, const Pyramid& pyramid,
                                        const scene::Scene& scene, const Ground& ground,
                                        double* draw_seconds) {
  image::Image image = lit_image(ground);
  Answers answers{scene, ground, image};
  const Result<Done> answered = answer({{pyramid.q, level_of(with, pyramid, answers)}}, answers);
  if (!answered) return answered.diagnostics();
  tell_origin(*with.program, image);
  if (draw_seconds) *draw_seconds = answers.seconds;
  return image;
}

}  // namespace gnomon::technique
