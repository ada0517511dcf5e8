// SPDX-License-Identifier: MIT
// How scene terms become numbers for a method: sun and camera. The one place where both methods and oracle
// take them.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// Unit vector towards the sun: x east, y north, z up. Exact on the axes, on the diagonals and at the zenith.
[[nodiscard]] glm::dvec3 to_sun(const scene::Sun& sun);

/// The same in single precision. A sun that stands above the plane stays above it: an elevation too small for
/// a float becomes the smallest one.
[[nodiscard]] glm::vec3 to_sun_single(const scene::Sun& sun);

/// The map camera: pixel (x, y) looks at s = (x + 0.5) / width, t = (y + 0.5) / height of the map.
struct MapView {
  glm::ivec2 size;             ///< pixels
  glm::vec2 texels_per_pixel;  ///< of the base map, in single precision: what the shader multiplies by

  /// Texels of the base map from its west (x) or north (y) edge; the very product that the shader forms.
  [[nodiscard]] float column(int x) const { return (static_cast<float>(x) + 0.5F) * texels_per_pixel.x; }
  [[nodiscard]] float row(int y) const { return (static_cast<float>(y) + 0.5F) * texels_per_pixel.y; }
  /// Whether every pixel looks at a sample.
  [[nodiscard]] bool on_samples() const { return texels_per_pixel == glm::vec2(1.0F, 1.0F); }
};
[[nodiscard]] MapView map_view(const scene::MapCamera& camera, const terrain::HeightMap& map);

}  // namespace gnomon::technique
