// SPDX-License-Identifier: MIT
// What the programs share that show what a camera sees: its uniforms, and the channels they write.
#ifndef GNOMON_PROGRAMS_VIEW_PASS_GLSL
#define GNOMON_PROGRAMS_VIEW_PASS_GLSL

#include "camera_pass.glsl"
#include <gnomon/relief/level_of_detail.glsl>
#include <gnomon/shading/lit.glsl>
#include <gnomon/view/footprint.glsl>

uniform int u_level;       // of detail; below 0: by Algo 1
uniform float u_max_anisotropy;
uniform int u_coarsest;    // level of detail

#define NOTHING_SEEN -1.0
#define UNDECIDED -2.0

// column, row (texels), depth (metres along the ray), level of detail or NOTHING_SEEN or UNDECIDED
layout(location = 0) out vec4 o_seen;

// The level of a pixel that sees the ground at `at`; direction: of its ray, any length; apart: what moves the pixel's
// point by u_right and u_down, lengths of u_forward (perspective) or 1.
int level_at(vec2 at, vec3 direction, float apart) {
  if (u_level >= 0) return u_level;
  GnomonMap map = pass_map();
  vec3 normal = gnomon_surface_normal(map, gnomon_receiver_at(at.x, at.y, 0.0), u_q);
  return gnomon_level_of_detail(gnomon_footprint(map, normal, direction, u_right * apart),
                                gnomon_footprint(map, normal, direction, u_down * apart), u_max_anisotropy, u_coarsest);
}

#endif
