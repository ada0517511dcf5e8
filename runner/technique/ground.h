// SPDX-License-Identifier: MIT
// The points of the map that a camera's pixels look at: what every shadow method, and the oracle, is asked
// for.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// Row-major, a value a pixel.
struct Ground {
  glm::ivec2 size{};  ///< pixels
  std::vector<float>
      column;              ///< texels of the base map from its west edge, the very numbers that methods take
  std::vector<float> row;  ///< texels of the base map from its north edge
  std::vector<float> valid;  ///< 1, or 0 where the pixel sees no ground
  std::vector<float> q;      ///< level of detail
  std::vector<float> depth;  ///< metres along the ray, 0 for sky; empty for the map camera
  /// The map camera: texels of the base map in a pixel; 0 for other cameras.
  glm::vec2 texels_per_pixel{};

  [[nodiscard]] std::size_t pixels() const { return column.size(); }
  /// Of a pixel's values in the lists.
  [[nodiscard]] std::size_t index(glm::ivec2 pixel) const {
    return static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(size.x) +
           static_cast<std::size_t>(pixel.x);
  }
  /// Whether every pixel looks at a sample.
  [[nodiscard]] bool on_samples() const { return texels_per_pixel == glm::vec2(1.0F, 1.0F); }
  /// The levels that valid pixels ask for.
  [[nodiscard]] std::set<int> levels() const;
  /// The valid pixels that ask for level q, by their index.
  [[nodiscard]] std::vector<std::size_t> asking(int level) const;
};

/// Makes pixels invalid that have no surface under them, on the map or on the level that they ask for.
void leave_out_holes(Ground& ground, const terrain::HeightMap& map);

/// The image of these points before any is asked: lit, in no steps. Channels b_shadow, k_shadow, steps, q,
/// valid and, but for the map camera, column, row, depth.
[[nodiscard]] image::Image lit_image(const Ground& ground);

/// No pixel sees ground yet.
[[nodiscard]] Ground empty_ground(glm::ivec2 size, const scene::Shadow& shadow);

/// Pixel (x, y) looks at s = (x + 0.5) / width, t = (y + 0.5) / height of the map.
[[nodiscard]] Ground map_ground(const scene::MapCamera& camera, const scene::Shadow& shadow,
                                const terrain::HeightMap& map);

/// The points in the channels `column` and `row` of an image; pixels whose `valid` is 0 stay so, and with q
/// "auto" its channel `q` is taken. Fails, naming the file, where a channel is missing, a point lies outside
/// of the map, or a level does not exist.
[[nodiscard]] Result<Ground> points_ground(const image::Image& image, const std::string& file,
                                           const scene::Shadow& shadow, const terrain::HeightMap& map);

/// What a perspective or orthographic camera sees: a ray a pixel against the surface of `base`, which is
/// level 0 of the map. The rays pass `offset` pixels right of and below the pixels' centres. Fails (kFailed)
/// if a ray reached its step bound. `draw_seconds` as for render_shadow.
[[nodiscard]] Result<Ground> seen_ground(ProgramCache& programs, const Pyramid& base,
                                         const scene::ViewCamera& camera, const scene::Shadow& shadow,
                                         glm::dvec2 offset = {}, double* draw_seconds = nullptr);

/// The same by the oracle's rays, in double precision and without GL.
[[nodiscard]] Ground reference_ground(const terrain::HeightMap& map, const scene::ViewCamera& camera,
                                      const scene::Shadow& shadow, glm::dvec2 offset = {});

/// The same for one pixel alone: a ground of that one.
[[nodiscard]] Ground reference_pixel(const terrain::HeightMap& map, const scene::ViewCamera& camera,
                                     const scene::Shadow& shadow, glm::ivec2 pixel);

}  // namespace gnomon::technique
