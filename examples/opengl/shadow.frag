// SPDX-License-Identifier: MIT
// The map from above, a pixel a sample: relief in grey, b_shadow in alpha.
#include <gnomon/host/r32f.glsl>
#include <gnomon/relief/multilevel.glsl>

uniform ivec2 u_size;     // samples of the map, west to east and north to south
uniform vec2 u_spacing;   // metres between them
uniform float u_highest;  // highest sample, metres
uniform int u_top_level;  // mip levels of gnomon_extrema
uniform vec3 u_to_sun;    // unit vector: x east, y north, z up
layout(location = 0) out vec4 o_colour;

// How much light the ground gets from a sun that nothing hides, 0 to 1.
float light_at(ivec2 at) {
  float east = gnomon_host_height(at + ivec2(1, 0), 0) - gnomon_host_height(at - ivec2(1, 0), 0);
  float north = gnomon_host_height(at - ivec2(0, 1), 0) - gnomon_host_height(at + ivec2(0, 1), 0);
  vec3 normal = normalize(vec3(-east / (2.0 * u_spacing.x), -north / (2.0 * u_spacing.y), 1.0));
  return max(dot(normal, u_to_sun), 0.0);
}

void main() {
  // gl_FragCoord is the middle of a pixel, as a sample is the middle of a texel; row 0 is drawn first, the north.
  GnomonReceiver here = gnomon_receiver_at(gl_FragCoord.x, gl_FragCoord.y, 0.0);
  GnomonMap map = GnomonMap(u_size, vec2(u_size), u_spacing, u_highest, u_top_level);
  GnomonShadow answer = gnomon_multilevel(map, here, u_to_sun, 0, 8 * (u_size.x + u_size.y));

  float light = 0.25 + 0.75 * light_at(ivec2(gl_FragCoord.xy)) * (1.0 - answer.shadow);
  // A ray without an answer is an error of the host, never light: -1 says so to main.cpp.
  o_colour = vec4(vec3(light), answer.cause == GNOMON_CAUSE_UNDECIDED ? -1.0 : answer.shadow);
}
