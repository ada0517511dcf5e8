// SPDX-License-Identifier: MIT
// The oracle as a method: the image that every shader is held against.
#pragma once

#include <optional>

#include "image/image.h"
#include "scene/scene.h"
#include "technique/ground.h"
#include "terrain/height_map.h"

namespace gnomon::technique {

/// The oracle's answer for every point of `ground`: channels b_shadow, k_shadow, q, steps (0), valid, horizon
/// (radians, -pi/2 where nothing lies ahead), band (1 where single precision may decide either way) and, but
/// for the map camera, column, row, depth. `level`: H_q that answers, by default the one that the point asks
/// for.
[[nodiscard]] image::Image reference_image(const scene::Scene& scene, const terrain::HeightMap& base,
                                           const Ground& ground, std::optional<int> level = {});

}  // namespace gnomon::technique
