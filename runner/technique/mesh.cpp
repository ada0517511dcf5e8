// SPDX-License-Identifier: MIT
#include "technique/mesh.h"

#include <algorithm>
#include <limits>

#include "technique/map_host.h"

namespace gnomon::technique {
namespace {

/// As programs/mesh.vert counts them: by the module, which asks no map for it.
int nodes(int samples, int step) {
  const terrain::HeightMap none;
  return MapHost(none).gnomon_grid_nodes(samples, step);
}

}  // namespace

gl::Mesh grid_mesh(const Pyramid& pyramid, int step, gl::Faces faces) {
  return {.strips = nodes(pyramid.size.y, step) - 1,
          .strip_vertices = 2 * nodes(pyramid.size.x, step),
          .faces = faces};
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
