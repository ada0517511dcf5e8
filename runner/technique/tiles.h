// SPDX-License-Identifier: MIT
// Large images are drawn in parts.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "gl/draw.h"
#include "gnomon/diagnostic.h"
#include "technique/camera.h"
#include "technique/ground.h"
#include "technique/pyramid.h"

namespace gnomon::technique {

/// Pixels a side that one draw covers: a hardware driver resets a context whose draw takes seconds, and a
/// target for a whole 16384 x 16384 view would not fit in software GL.
inline constexpr int kTile = 1024;

struct Tile {
  glm::ivec2 first;  ///< pixel of the image
  glm::ivec2 size;   ///< pixels
};
[[nodiscard]] std::vector<Tile> tiles_of(glm::ivec2 image);

using Uniforms = std::vector<std::pair<std::string, gl::Uniform>>;

/// What programs/map_pass.glsl takes, but for u_first_pixel.
[[nodiscard]] Uniforms map_uniforms(const Pyramid& pyramid);

/// What programs/camera_pass.glsl takes beside that: rays that pass `offset` pixels right of and below the
/// pixels' centres.
[[nodiscard]] Uniforms camera_uniforms(const CameraRays& rays, glm::dvec2 offset = {});

/// Blocks and patches that a ray may visit: 8 (width + height) always suffices.
[[nodiscard]] int step_limit(glm::ivec2 samples);

/// The samplers of host/r32f.glsl.
[[nodiscard]] std::vector<gl::Sampler> map_samplers(const Pyramid& pyramid);

/// A texel a pixel of the tile: column, row, valid, and a value of the caller's.
[[nodiscard]] Result<gl::Texture> upload_points(const Ground& ground, const Tile& tile,
                                                const std::vector<float>& fourth);

/// The four values of a pixel that a tile's draw wrote.
struct Texels {
  std::vector<float> values;
  int width = 0;
  [[nodiscard]] const float* at(int x, int y) const {
    return &values[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                        static_cast<std::size_t>(x))];
  }
};

/// An RGBA32F target.
[[nodiscard]] Result<gl::Texture> answers_of(glm::ivec2 size);

/// As gl::draw; adds the draws' own time to `seconds`, where given.
[[nodiscard]] Result<Done> draw_timed(std::span<const gl::Pass> passes, double* seconds);

/// Draws one tile of an image, or of a mesh, into an RGBA32F target and reads it back; adds the draw's own
/// time to `seconds`, where given. Target, the mesh's depth, u_first_pixel and u_tile_size are the tile's.
[[nodiscard]] Result<Texels> draw_tile(const Tile& tile, gl::Pass pass, double* seconds);

}  // namespace gnomon::technique
