// SPDX-License-Identifier: MIT
// What the fragments of mesh.vert share.
#ifndef GNOMON_PROGRAMS_MESH_PASS_GLSL
#define GNOMON_PROGRAMS_MESH_PASS_GLSL

#include "map_pass.glsl"
#include <gnomon/core/surface.glsl>

layout(location = 0) in vec2 v_at;
layout(location = 1) in vec3 v_place;
layout(location = 2) in float v_hole;

// Where the fragment lies, texels of the level: interpolation may step over the edge by its rounding.
vec2 mesh_at() {
  return clamp(v_at, vec2(0.0), u_map_domain);
}

// Whether the map has no surface under the fragment.
bool mesh_has_hole(vec2 at) {
  return v_hole > 0.0 || !gnomon_has_surface(gnomon_receiver_at(at.x, at.y, 0.0), u_q);
}

#endif
