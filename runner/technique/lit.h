// SPDX-License-Identifier: MIT
// The lit image of what a camera sees.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"
#include "technique/ground.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// Adds the channels R, G, B (linear; 0 for sky) to an image that has k_shadow, for the points of `ground`
/// and their colours `albedo`; `base` is level 0 of the map.
[[nodiscard]] Result<Done> light(ProgramCache& programs, const Pyramid& base, const scene::Scene& scene,
                                 const Ground& ground, const std::vector<glm::vec3>& albedo,
                                 image::Image& image);

/// The same by the modules as C++, without GL.
void light_reference(const terrain::HeightMap& map, const scene::Scene& scene, const Ground& ground,
                     const std::vector<glm::vec3>& albedo, image::Image& image);

/// The lit image as a picture: sRGB, with a sky behind it.
[[nodiscard]] image::Picture lit_picture(const image::Image& image);

}  // namespace gnomon::technique
