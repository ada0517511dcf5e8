// SPDX-License-Identifier: MIT
#include "technique/mesh.h"

#include <algorithm>
#include <limits>

#include "technique/map_host.h"

namespace gnomon::technique {
namespace {

/// Grids are counted and placed as programs/mesh.vert does, by the module, which asks no map for it.
const MapHost& module() {
  static const terrain::HeightMap none;
  static const MapHost host(none);
  return host;
}

}  // namespace

glm::ivec2 grid_cells(const Pyramid& pyramid, int step) {
  return glm::ivec2(module().gnomon_grid_nodes(pyramid.size.x, step),
                    module().gnomon_grid_nodes(pyramid.size.y, step)) -
         1;
}

glm::dvec2 grid_node(const Pyramid& pyramid, int step, glm::ivec2 node) {
  return {module().gnomon_grid_coordinate(node.x, pyramid.size.x, pyramid.domain.x, step),
          module().gnomon_grid_coordinate(node.y, pyramid.size.y, pyramid.domain.y, step)};
}

gl::Mesh grid_mesh(const Pyramid& pyramid, int step, gl::Faces faces) {
  return {.parts = {{.cells = grid_cells(pyramid, step)}}, .faces = faces};
}

Corners box_of(const Pyramid& pyramid) {
  const glm::dvec2 far_corner = glm::dvec2(pyramid.domain) * glm::dvec2(pyramid.spacing);
  Corners corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? far_corner.x : 0.0, (i & 2) != 0 ? far_corner.y : 0.0,
                         double{(i & 4) != 0 ? pyramid.highest : pyramid.lowest});
  }
  return corners;
}

glm::dvec2 extent_along(const Pyramid& pyramid, glm::dvec3 origin, glm::dvec3 direction) {
  glm::dvec2 extent(std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest());
  for (const glm::dvec3& corner : box_of(pyramid)) {
    const double along = glm::dot(corner - origin, direction);
    extent = {std::min(extent.x, along), std::max(extent.y, along)};
  }
  return extent;
}

Uniforms mesh_uniforms(const Pyramid& pyramid, const CameraRays& rays, int step) {
  // Depth keeps its relative precision down to any distance: the near plane only has to be near enough.
  const float near = 1e-3F * std::min(pyramid.spacing.x, pyramid.spacing.y);
  const double away = extent_along(pyramid, rays.eye, rays.forward).y;
  // A little beyond the last node, so that its depth stays above that of the background.
  const auto far = static_cast<float>(away > 0 ? 1.001 * away : 1.0);
  return {{"u_grid_step", step}, {"u_near", near}, {"u_far", far}};
}

}  // namespace gnomon::technique
