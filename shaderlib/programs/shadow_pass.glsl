// SPDX-License-Identifier: MIT
// What every hard-shadow program shares: its inputs, the points that it is asked for, and the channels it writes.
#ifndef GNOMON_PROGRAMS_SHADOW_PASS_GLSL
#define GNOMON_PROGRAMS_SHADOW_PASS_GLSL

#include "map_pass.glsl"
#include <gnomon/core/shadow.glsl>
#include <gnomon/relief/shade.glsl>

uniform vec2 u_texels_per_pixel;  // of the base map, map camera; 0 where u_points tells the points
uniform sampler2D u_points;       // column, row (texels of the base map)
uniform float u_level_scale;      // texels of H_q in one of the base map: 2^-q
uniform float u_receiver_height;  // metres above H_q
uniform vec3 u_to_sun;            // unit vector, x east, y north, z up
uniform vec2 u_k;                 // k_dark, k_bright

// b_shadow, k_shadow, steps, cause (GNOMON_CAUSE_...)
layout(location = 0) out vec4 o_shadow;

// Where the shadow is asked, texels of the base map. The map camera's pixel (x, y) looks at s = (x + 0.5) / width,
// t = (y + 0.5) / height of the map, row 0 in the north; other points are a list, a texel each.
vec2 pass_point() {
  if (u_texels_per_pixel.x > 0.0) return (gl_FragCoord.xy + u_first_pixel) * u_texels_per_pixel;
  return texelFetch(u_points, ivec2(gl_FragCoord.xy), 0).xy;
}

GnomonReceiver pass_receiver() {
  vec2 at = pass_point() * u_level_scale;
  return gnomon_receiver_at(at.x, at.y, u_receiver_height);
}

// Methods that filter answer with a share: more than half of it is a shadow.
void write_shadow(GnomonShadow answer) {
  float k = gnomon_k_shadow(answer.shadow, u_to_sun.z, u_k.x, u_k.y);
  o_shadow = vec4(answer.shadow > 0.5 ? 1.0 : 0.0, k, float(answer.steps), float(answer.cause));
}

#endif
