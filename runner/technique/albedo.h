// SPDX-License-Identifier: MIT
// The colour of the ground under each pixel.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "gnomon/diagnostic.h"
#include "scene/scene.h"
#include "technique/ground.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// Linear colours, looked up with linear interpolation and clamped to the edge.
struct Albedo {
  int width = 1, height = 1;
  std::vector<glm::vec3> colours;  ///< row-major, the north row first
  bool by_height = false;          ///< a row of colours from `lowest` to `highest`, else laid over the map
  double lowest = 0, highest = 0;  ///< metres
};

/// Reads what `ground` names. Fails where the image cannot be read or has neither one nor three channels.
[[nodiscard]] Result<Albedo> load_albedo(const scene::Ground& ground);

/// The colour under each pixel; any where it sees no ground.
[[nodiscard]] std::vector<glm::vec3> albedo_under(const Ground& ground, const Albedo& albedo,
                                                  const terrain::HeightMap& map);

}  // namespace gnomon::technique
