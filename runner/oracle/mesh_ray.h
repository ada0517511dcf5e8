// SPDX-License-Identifier: MIT
// Where a view ray meets the surface drawn as triangles, in double precision.
#pragma once

#include <optional>
#include <vector>

#include "oracle/oracle.h"
#include "oracle/view_ray.h"

namespace gnomon::oracle {

/// Where a ray meets a mesh.
struct MeshHit {
  double t = 0;  ///< origin + t * direction
  /// The cell, texels from the map's west and north edge.
  double west = 0, east = 0, north = 0, south = 0;
  bool north_western = false;  ///< which of its two triangles
};

/// A grid of triangles over a surface: nodes on both edges of the domain, on the first and the last sample
/// and on each `step`-th between them; cells cut from their south-western to their north-eastern node.
class MeshTracer {
 public:
  /// `surface` has to outlive it. `cull_back_faces`: triangles are seen from above only.
  MeshTracer(const Surface& surface, int step, bool cull_back_faces);

  /// The smallest t >= 0 at which origin + t * direction meets a triangle; absent where it meets none.
  /// Triangles with a node that has no surface, and places where the surface has none, are passed.
  [[nodiscard]] std::optional<double> first_hit(const ViewRay& ray) const;

  /// The same, with the triangle.
  [[nodiscard]] std::optional<MeshHit> first_triangle(const ViewRay& ray) const;

 private:
  struct Track;
  [[nodiscard]] std::optional<MeshHit> hit_in_cell(const Track& track, int column, int row, double from,
                                                   double to) const;

  const Surface& surface_;
  bool cull_back_faces_;
  double highest_;               ///< sample, metres
  std::vector<double> columns_;  ///< of the nodes, texels
  std::vector<double> rows_;
};

}  // namespace gnomon::oracle
