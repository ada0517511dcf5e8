// SPDX-License-Identifier: MIT
// summary: How far on the map the point moves that a pixel sees, from one pixel to the next.
// source:  Igehy 1999, "Tracing ray differentials": transfer to the tangent plane; the s_x ... t_y of Algo 1
// host:    none
// options: none
#ifndef GNOMON_VIEW_FOOTPRINT_GLSL
#define GNOMON_VIEW_FOOTPRINT_GLSL

#include <gnomon/core/map.glsl>

// Texels of the level per pixel, eastward and southward, on the plane through the hit with this normal. `moved`: how far
// the ray itself moves at the hit from this pixel to the next, metres: its depth times the change of the direction, or
// the change of the origin of parallel rays. direction: the ray's, of any length. Edge-on ground gives large numbers.
vec2 gnomon_footprint(GnomonMap map, vec3 normal, vec3 direction, vec3 moved) {
  float facing = min(dot(normal, direction), -1e-6f * length(direction));
  vec3 on_plane = moved - direction * (dot(normal, moved) / facing);
  return vec2(on_plane.x / map.spacing.x, -on_plane.y / map.spacing.y);
}

#endif
