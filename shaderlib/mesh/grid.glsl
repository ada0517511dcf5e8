// SPDX-License-Identifier: MIT
// summary: The relief as a regular grid of triangles, as engines draw it.
// source:  docs/algorithms.md, "Meshes"
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_MESH_GRID_GLSL
#define GNOMON_MESH_GRID_GLSL

#include <gnomon/core/ray.glsl>
#include <gnomon/core/surface.glsl>

// Nodes along an axis: the first and the last sample, each `step`-th between them, and one on either edge of the domain.
int gnomon_grid_nodes(int samples, int step) {
  return (samples - 2 + step) / step + 3;
}

// Where node 0 .. nodes - 1 of an axis lies, in texels of the level.
float gnomon_grid_coordinate(int node, int samples, float domain, int step) {
  if (node <= 0) return 0.0f;
  if (node >= gnomon_grid_nodes(samples, step) - 1) return domain;
  return min(float(min((node - 1) * step, samples - 1)) + 0.5f, domain);
}

// The node at whose cell the coordinate lies, or on whose line.
int gnomon_grid_cell(float coordinate, int samples, int step) {
  int last = gnomon_grid_nodes(samples, step) - 2;
  if (coordinate >= float(samples) - 0.5f) return last;
  return clamp(int(floor((coordinate - 0.5f) / float(step))) + 1, 0, last);
}

// Height of a node at (column, row) in texels of the level, metres; GNOMON_NO_SAMPLE where it has none: on a sample without
// data, or between samples where there is no surface.
float gnomon_grid_height(float column, float row, int q) {
  ivec2 here = ivec2(int(floor(column)), int(floor(row)));
  bool on_sample = column - floor(column) == 0.5f && row - floor(row) == 0.5f;
  if (on_sample) return gnomon_host_height(here, q);
  GnomonReceiver at = gnomon_on_surface(gnomon_receiver_at(column, row, 0.0f), q);
  float base = gnomon_host_height(at.patch_index, q);
  GnomonPatch under = gnomon_patch(at.patch_index, base, q);
  return under.hole ? GNOMON_NO_SAMPLE : base + gnomon_patch_height(under, at.fraction);
}

// A point of the mesh.
struct GnomonGridPoint {
  float height;  // metres
  vec3 normal;   // of its triangle, unit: x east, y north, z up
  bool hole;     // a node of the triangle has no height: nothing else has a meaning
};

// The mesh at (column, row) in texels of the level. Cells are cut from their south-western to their north-eastern node.
GnomonGridPoint gnomon_grid_point(GnomonMap map, float column, float row, int step, int q) {
  int west = gnomon_grid_cell(column, map.size.x, step);
  int north = gnomon_grid_cell(row, map.size.y, step);
  float x0 = gnomon_grid_coordinate(west, map.size.x, map.domain.x, step);
  float x1 = gnomon_grid_coordinate(west + 1, map.size.x, map.domain.x, step);
  float y0 = gnomon_grid_coordinate(north, map.size.y, map.domain.y, step);
  float y1 = gnomon_grid_coordinate(north + 1, map.size.y, map.domain.y, step);
  float north_east = gnomon_grid_height(x1, y0, q);
  float south_west = gnomon_grid_height(x0, y1, q);
  vec2 size = vec2(max(x1 - x0, 1e-6f), max(y1 - y0, 1e-6f));
  vec2 at = vec2((column - x0) / size.x, (row - y0) / size.y);
  bool first = at.x + at.y <= 1.0f;
  float corner = first ? gnomon_grid_height(x0, y0, q) : gnomon_grid_height(x1, y1, q);
  // From the corner off the diagonal along both sides.
  vec2 rise = first ? vec2(north_east - corner, south_west - corner) : vec2(corner - south_west, corner - north_east);
  vec2 from = first ? at : vec2(at.x - 1.0f, at.y - 1.0f);
  GnomonGridPoint point;
  point.hole = !gnomon_is_sample(min(corner, min(north_east, south_west)));
  point.height = corner + (rise.x * from.x + rise.y * from.y);
  point.normal = normalize(vec3(-rise.x / (size.x * map.spacing.x), rise.y / (size.y * map.spacing.y), 1.0f));
  return point;
}

#endif
