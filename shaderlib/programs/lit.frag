// SPDX-License-Identifier: MIT
// The lit image of what a camera sees.
#include <gnomon/host/r32f.glsl>
#include <gnomon/shading/lit.glsl>
#include "map_pass.glsl"

// A texel a pixel of the tile.
uniform sampler2D u_ground;  // column, row (texels of the base map), valid, k_shadow
uniform sampler2D u_albedo;  // linear colour
uniform vec3 u_to_sun;
uniform float u_ambient;

// Linear colour; alpha 1 where there is ground
layout(location = 0) out vec4 o_colour;

void main() {
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec4 ground = texelFetch(u_ground, pixel, 0);
  vec3 normal = gnomon_surface_normal(pass_map(), gnomon_receiver_at(ground.x, ground.y, 0.0), u_q);
  vec3 colour = gnomon_lit(texelFetch(u_albedo, pixel, 0).rgb, normal, u_to_sun, ground.w, u_ambient);
  o_colour = ground.z != 0.0 ? vec4(colour, 1.0) : vec4(0.0);
}
