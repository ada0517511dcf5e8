// SPDX-License-Identifier: MIT
// The relief as a mesh for programs/mesh.vert.
#pragma once

#include <vector>

#include "gl/draw.h"
#include "technique/camera.h"
#include "technique/pyramid.h"
#include "technique/tiles.h"

namespace gnomon::technique {

/// Cells of the grid over a pyramid's level that has a node on every `step`-th sample.
[[nodiscard]] glm::ivec2 grid_cells(const Pyramid& pyramid, int step);

/// Where a node of it lies: column and row in texels of the level.
[[nodiscard]] glm::dvec2 grid_node(const Pyramid& pyramid, int step, glm::ivec2 node);

/// The whole of it as a mesh; without depth.
[[nodiscard]] gl::Mesh grid_mesh(const Pyramid& pyramid, int step, gl::Faces faces);

/// What programs/mesh.vert takes beside the uniforms of map and camera.
[[nodiscard]] Uniforms mesh_uniforms(const Pyramid& pyramid, const CameraRays& rays, int step);

using Corners = std::vector<glm::dvec3>;  ///< of a convex body, metres

/// The box that holds a level.
[[nodiscard]] Corners box_of(const Pyramid& pyramid);

/// Where the mesh begins and ends along `direction`, metres from `origin`: x, y of the result.
[[nodiscard]] glm::dvec2 extent_along(const Pyramid& pyramid, glm::dvec3 origin, glm::dvec3 direction);

}  // namespace gnomon::technique
