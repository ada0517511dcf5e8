// SPDX-License-Identifier: MIT
// A ray a pixel, each with a receiver and a sun of its own: asks the method on the GPU what no camera can ask.
#include <gnomon/host/r32f.glsl>
#include <gnomon/relief/multilevel.glsl>

uniform highp sampler2D u_receivers;  // column, row (texels), height above ground (metres)
uniform highp sampler2D u_suns;       // unit vector towards the sun
uniform vec2 u_map_spacing;
uniform float u_map_highest;
uniform int u_map_top_level;
layout(location = 0) out vec4 o_shadow;

void main() {
  GnomonMap map;
  map.size = textureSize(gnomon_heights, 0);
  map.domain = vec2(map.size);
  map.spacing = u_map_spacing;
  map.highest = u_map_highest;
  map.top_level = u_map_top_level;
  ivec2 ray = ivec2(gl_FragCoord.xy);
  vec3 at = texelFetch(u_receivers, ray, 0).xyz;
  vec3 to_sun = texelFetch(u_suns, ray, 0).xyz;
  GnomonShadow answer = gnomon_multilevel(map, gnomon_receiver_at(at.x, at.y, at.z), to_sun, 0, 8 * (map.size.x + map.size.y));
  o_shadow = vec4(answer.shadow, float(answer.steps), float(answer.cause), 0.0);
}
