// SPDX-License-Identifier: MIT
// How a scene's sun becomes numbers for a method. The one place where both methods and oracle take them.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace gnomon::technique {

/// Unit vector towards the sun: x east, y north, z up. Exact on the axes, on the diagonals and at the zenith.
[[nodiscard]] glm::dvec3 to_sun(const scene::Sun& sun);

/// The same in single precision. A sun that stands above the plane stays above it: an elevation too small for
/// a float becomes the smallest one.
[[nodiscard]] glm::vec3 to_sun_single(const scene::Sun& sun);

}  // namespace gnomon::technique
