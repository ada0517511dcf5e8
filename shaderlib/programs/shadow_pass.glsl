// SPDX-License-Identifier: MIT
// What every hard-shadow program shares: its inputs, the map camera, and the channels it writes.
#ifndef GNOMON_PROGRAMS_SHADOW_PASS_GLSL
#define GNOMON_PROGRAMS_SHADOW_PASS_GLSL

#include <gnomon/core/map.glsl>
#include <gnomon/core/shadow.glsl>
#include <gnomon/relief/shade.glsl>

uniform ivec2 u_map_size;         // samples of H_q
uniform vec2 u_map_domain;        // texels of H_q
uniform vec2 u_map_spacing;       // metres a texel of H_q
uniform float u_map_highest;      // metres
uniform int u_map_top_level;      // coarsest level of block maxima
uniform vec2 u_texels_per_pixel;  // of H_q
uniform float u_receiver_height;  // metres above H_q
uniform vec3 u_to_sun;            // unit vector, x east, y north, z up
uniform vec2 u_k;                 // k_dark, k_bright
uniform int u_q;
uniform int u_step_limit;
uniform vec2 u_first_pixel;      // of the tile that is drawn

// b_shadow, k_shadow, steps, cause (GNOMON_CAUSE_...)
layout(location = 0) out vec4 o_shadow;

GnomonMap pass_map() {
  GnomonMap map;
  map.size = u_map_size;
  map.domain = u_map_domain;
  map.spacing = u_map_spacing;
  map.highest = u_map_highest;
  map.top_level = u_map_top_level;
  return map;
}

// Pixel (x, y) looks at s = (x + 0.5) / width, t = (y + 0.5) / height of the map, row 0 in the north.
GnomonReceiver pass_receiver() {
  vec2 at = (gl_FragCoord.xy + u_first_pixel) * u_texels_per_pixel;
  return gnomon_receiver_at(at.x, at.y, u_receiver_height);
}

void write_shadow(GnomonShadow answer) {
  float k = gnomon_k_shadow(answer.shadow, u_to_sun.z, u_k.x, u_k.y);
  o_shadow = vec4(answer.shadow, k, float(answer.steps), float(answer.cause));
}

#endif
