// SPDX-License-Identifier: MIT
// Where a pixel asks for its shadow. Internal to this folder.
#pragma once

#include "trace/trace.h"

namespace gnomon::trace {

/// The point of a pixel without GL. What a perspective or orthographic camera sees is found by the modules,
/// as on the GPU, and by the oracle beside them. Fails where the image has no such pixel, or an image of
/// points cannot be read.
[[nodiscard]] Result<Point> point_of(const scene::Scene& scene, const terrain::HeightMap& base,
                                     glm::ivec2 pixel);

}  // namespace gnomon::trace
