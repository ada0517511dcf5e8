// SPDX-License-Identifier: MIT
// The relief as a mesh for programs/mesh.vert.
#pragma once

#include <vector>

#include "gl/draw.h"
#include "technique/camera.h"
#include "technique/pyramid.h"
#include "technique/tiles.h"

namespace gnomon::technique {

/// The strips of a pyramid's level with a node on every `step`-th sample; without window and depth.
[[nodiscard]] gl::Mesh grid_mesh(const Pyramid& pyramid, int step, gl::Faces faces);

/// What programs/mesh.vert takes beside the uniforms of map and camera.
[[nodiscard]] Uniforms mesh_uniforms(const Pyramid& pyramid, const CameraRays& rays, int step);

using Corners = std::vector<glm::dvec3>;  ///< of a convex body, metres

/// The box that holds a level.
[[nodiscard]] Corners box_of(const Pyramid& pyramid);

/// Where the mesh begins and ends along `direction`, metres from `origin`: x, y of the result.
[[nodiscard]] glm::dvec2 extent_along(const Pyramid& pyramid, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace gnomon::technique
