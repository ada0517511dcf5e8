// SPDX-License-Identifier: MIT
// The parts of a mesh that a cascade holds: engines leave out the others, and so does the comparison with
// them.
#pragma once

#include <vector>

#include "gl/draw.h"
#include "technique/cascades.h"
#include "technique/pyramid.h"

namespace gnomon::technique {

/// The parts of the grid of `cascades.step` that can cast into a square of the fit: all whose box, seen along
/// the sun's rays, touches it, however far towards the sun. The whole grid where the pyramid has no
/// height_ranges.
[[nodiscard]] std::vector<gl::Mesh::Part> casters(const Pyramid& pyramid, const scene::Cascades& cascades,
                                                  const CascadeFit& fit, const CascadeSquare& square);

}  // namespace gnomon::technique
