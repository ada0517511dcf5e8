// SPDX-License-Identifier: MIT
// The oracle as a method: the image that every shader is held against.
#pragma once

#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// Channels b_shadow, k_shadow, q, steps (0), valid, horizon (radians, -pi/2 where nothing lies ahead) and
/// band (1 where single precision may decide either way). `level`: H_q that answers, by default the scene's
/// own q.
[[nodiscard]] image::Image reference_image(const scene::Scene& scene, const terrain::HeightMap& base,
                                           int level);

}  // namespace gnomon::technique
