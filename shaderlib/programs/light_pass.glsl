// SPDX-License-Identifier: MIT
// The cascades as programs that ask them take them.
#ifndef GNOMON_PROGRAMS_LIGHT_PASS_GLSL
#define GNOMON_PROGRAMS_LIGHT_PASS_GLSL

#include <gnomon/baseline/cascaded_shadow_maps.glsl>

uniform vec3 u_light_origin;
uniform vec3 u_light_right;
uniform vec3 u_light_down;
uniform float u_light_range;
uniform int u_light_cascades;
uniform int u_light_grid_step;
uniform vec2 u_light_bias;  // constant, slope
uniform int u_light_filter;
uniform vec3 u_cascades[GNOMON_MOST_CASCADES];  // corner, texel

GnomonLight pass_light() {
  GnomonLight light;
  light.origin = u_light_origin;
  light.right = u_light_right;
  light.down = u_light_down;
  light.range = u_light_range;
  light.size = u_light_size;
  light.cascades = u_light_cascades;
  light.grid_step = u_light_grid_step;
  light.bias = u_light_bias.x;
  light.slope_bias = u_light_bias.y;
  light.filter_width = u_light_filter;
  for (int i = 0; i < GNOMON_MOST_CASCADES; ++i) {
    light.cascade[i].corner = u_cascades[i].xy;
    light.cascade[i].texel = u_cascades[i].z;
  }
  return light;
}

#endif
