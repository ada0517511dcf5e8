// SPDX-License-Identifier: MIT
// The height map as every program that walks over it takes it.
#ifndef GNOMON_PROGRAMS_MAP_PASS_GLSL
#define GNOMON_PROGRAMS_MAP_PASS_GLSL

#include <gnomon/core/map.glsl>

uniform ivec2 u_map_size;     // samples of H_q
uniform vec2 u_map_domain;    // texels of H_q
uniform vec2 u_map_spacing;   // metres a texel of H_q
uniform float u_map_highest;  // metres
uniform int u_map_top_level;  // coarsest level of block maxima
uniform int u_q;
uniform int u_step_limit;
uniform vec2 u_first_pixel;  // of the tile that is drawn

GnomonMap pass_map() {
  GnomonMap map;
  map.size = u_map_size;
  map.domain = u_map_domain;
  map.spacing = u_map_spacing;
  map.highest = u_map_highest;
  map.top_level = u_map_top_level;
  return map;
}

#endif
