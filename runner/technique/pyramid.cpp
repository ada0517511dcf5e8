// SPDX-License-Identifier: MIT
#include "technique/pyramid.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "gl/draw.h"
#include "terrain/level.h"

namespace gnomon::technique {
namespace {

/// Levels above this one hold blocks of more than 128 patches, which a ray that climbs one level at a time
/// hardly ever reaches; stopping here keeps the padding below 128 patches a side.
constexpr int kTopLevel = 7;

int ceil_div(int a, int b) {
  return (a + b - 1) / b;
}

/// Mip sizes are halved rounding down: sides that are multiples of 2^(levels - 1) lose no block. `cells`:
/// patches or texels, of which level 1 takes 2 x 2 together.
gl::Size extrema_size(glm::ivec2 cells, int levels) {
  const int top_block = 1 << levels;
  const int below = 1 << (levels - 1);
  return {ceil_div(cells.x, top_block) * below, ceil_div(cells.y, top_block) * below};
}

/// 0 where the map has no data at all.
float lowest_sample(const terrain::HeightMap& base) {
  float lowest = std::numeric_limits<float>::max();
  for (const float sample : base.samples) {
    if (sample != terrain::kNoSample) lowest = std::min(lowest, sample);
  }
  return lowest < std::numeric_limits<float>::max() ? lowest : 0.0F;
}

Result<gl::Texture> upload(const terrain::HeightMap& base) {
  Result<gl::Texture> heights = gl::Texture::create(gl::Format::kR32F, {base.width, base.height});
  if (heights) heights->upload(base.samples);
  return heights;
}

Result<gl::Texture> coarser(const gl::Program& program, const gl::Texture& finer) {
  const gl::Size from = finer.size();
  Result<gl::Texture> heights =
      gl::Texture::create(gl::Format::kR32F, {ceil_div(from.width, 2), ceil_div(from.height, 2)});
  if (!heights) return heights;
  const Result<Done> drawn = gl::draw({.program = &program,
                                       .uniforms = {},
                                       .samplers = {{.name = "gnomon_heights", .texture = &finer}},
                                       .target = &heights.value()});
  if (!drawn) return drawn.diagnostics();
  return heights;
}

/// Fills the mip levels of `extrema`, each from the one below, the first from `heights`.
Result<Done> draw_levels(const gl::Program& program, const gl::Texture& heights, const char* sampler,
                         const gl::Texture& extrema) {
  for (int level = 1; level <= extrema.levels(); ++level) {
    // Only the levels below are visible to the shader: reading the one that is drawn would be undefined.
    const Result<Done> drawn =
        gl::draw({.program = &program,
                  .uniforms = {{"u_level", level}},
                  .samplers = {{.name = "gnomon_heights", .texture = &heights},
                               {.name = sampler, .texture = &extrema, .last_level = std::max(level - 2, 0)}},
                  .target = &extrema,
                  .target_level = level - 1});
    if (!drawn) return drawn;
  }
  return Done{};
}

}  // namespace

int block_levels(glm::ivec2 patches) {
  const auto longest = static_cast<unsigned>(std::max(patches.x, patches.y));
  return std::clamp(static_cast<int>(std::bit_width(longest - 1)), 1, kTopLevel);
}

Result<gl::Texture> build_level(ProgramCache& programs, const terrain::HeightMap& base, int q) {
  const Result<const CachedProgram*> program = programs.get("programs/level.frag");
  if (!program) return program.diagnostics();
  Result<gl::Texture> heights = upload(base);
  for (int level = 0; level < q && heights; ++level) heights = coarser((*program)->program, heights.value());
  return heights;
}

Result<gl::Texture> build_extrema(const gl::Program& program, const gl::Texture& heights) {
  const glm::ivec2 patches(heights.size().width + 1, heights.size().height + 1);
  const int levels = block_levels(patches);
  Result<gl::Texture> extrema = gl::Texture::create(gl::Format::kR32F, extrema_size(patches, levels), levels);
  if (!extrema) return extrema;
  if (const Result<Done> drawn = draw_levels(program, heights, "gnomon_extrema", *extrema); !drawn)
    return drawn.diagnostics();
  return extrema;
}

Result<std::optional<gl::Texture>> build_literal_extrema(ProgramCache& programs,
                                                         const terrain::HeightMap& base) {
  // The papers end H_ext one level before the single block.
  const int levels = terrain::coarsest_level(base.width, base.height) - 1;
  if (levels < 1) return std::optional<gl::Texture>{};
  const Result<const CachedProgram*> program = programs.get("programs/literal_extrema.frag");
  if (!program) return program.diagnostics();
  const Result<gl::Texture> heights = upload(base);
  if (!heights) return heights.diagnostics();
  Result<gl::Texture> extrema =
      gl::Texture::create(gl::Format::kRg32F, extrema_size({base.width, base.height}, levels), levels);
  if (!extrema) return extrema.diagnostics();
  if (const Result<Done> drawn =
          draw_levels((*program)->program, *heights, "gnomon_literal_extrema", *extrema);
      !drawn)
    return drawn.diagnostics();
  return std::optional<gl::Texture>(std::move(extrema).value());
}

Result<Pyramid> build_pyramid(ProgramCache& programs, const terrain::HeightMap& base, int q) {
  Result<gl::Texture> heights = build_level(programs, base, q);
  if (!heights) return heights.diagnostics();
  const Result<const CachedProgram*> program = programs.get("programs/extrema.frag");
  if (!program) return program.diagnostics();
  Result<gl::Texture> extrema = build_extrema((*program)->program, heights.value());
  if (!extrema) return extrema.diagnostics();
  const std::vector<float> top = extrema->download(extrema->levels() - 1);
  const gl::Size size = heights->size();
  const double scale = 1.0 / static_cast<double>(1 << q);
  return Pyramid{.heights = std::move(heights).value(),
                 .extrema = std::move(extrema).value(),
                 .q = q,
                 .size = {size.width, size.height},
                 .domain = glm::vec2(glm::dvec2(base.domain_width, base.domain_height) * scale),
                 .spacing = glm::vec2(glm::dvec2(base.spacing_x, base.spacing_y) / scale),
                 .highest = *std::max_element(top.begin(), top.end()),
                 .lowest = lowest_sample(base),
                 .holes = base.holes};
}

}  // namespace gnomon::technique
