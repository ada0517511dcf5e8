// SPDX-License-Identifier: MIT
// H_q and its block maxima as textures, built on the GPU for any map size and level.
#pragma once

#include <glm/glm.hpp>
#include <optional>

#include "gl/texture.h"
#include "gnomon/diagnostic.h"
#include "technique/height_ranges.h"
#include "technique/program_cache.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// One level of a map on the GPU; what programs/shadow_pass.glsl and host/r32f.glsl ask for.
struct Pyramid {
  gl::Texture heights;  ///< R32F, H_q
  gl::Texture extrema;  ///< R32F, mip level k: maxima over blocks of 2^(k + 1) x 2^(k + 1) patches
  /// The papers' H_ext of H_0, where a method has asked for it. RG32F, mip level k: highest and lowest over
  /// blocks of 2^(k + 1) x 2^(k + 1) texels.
  std::optional<gl::Texture> literal_extrema{};
  /// Of H_q, where a method has asked for them.
  std::optional<HeightRanges> height_ranges{};
  int q = 0;
  glm::ivec2 size{};    ///< samples of H_q
  glm::vec2 domain{};   ///< texels of H_q
  glm::vec2 spacing{};  ///< metres a texel of H_q
  float highest = 0;    ///< sample, metres
  float lowest = 0;     ///< of the base map, metres
  bool holes = false;   ///< whether the base map has some

  [[nodiscard]] int top_level() const { return extrema.levels(); }
};

/// How many levels of block maxima a map with so many patches has.
[[nodiscard]] int block_levels(glm::ivec2 patches);

/// H_q alone: its heights as a texture.
[[nodiscard]] Result<gl::Texture> build_level(ProgramCache& programs, const terrain::HeightMap& base, int q);

/// Block maxima of `heights` as Pyramid::extrema, drawn by a program that ends in programs/extrema_pass.glsl:
/// its host function knows the encoding of `heights`.
[[nodiscard]] Result<gl::Texture> build_extrema(const gl::Program& program, const gl::Texture& heights);

/// Pyramid::literal_extrema of a map. Without levels where the papers have none: a map of at most 2 x 2
/// samples.
[[nodiscard]] Result<std::optional<gl::Texture>> build_literal_extrema(ProgramCache& programs,
                                                                       const terrain::HeightMap& base);

/// Fails where the map is larger than the driver's textures (naming the limit) or memory runs out.
[[nodiscard]] Result<Pyramid> build_pyramid(ProgramCache& programs, const terrain::HeightMap& base, int q);

}  // namespace gnomon::technique
