// SPDX-License-Identifier: MIT
// What a perspective or orthographic camera sees of the relief: where on the map, how far away, at which level.
#include <gnomon/host/r32f.glsl>
#include <gnomon/relief/level_of_detail.glsl>
#include <gnomon/shading/lit.glsl>
#include <gnomon/view/footprint.glsl>
#include <gnomon/view/relief_view.glsl>
#include "map_pass.glsl"

uniform vec3 u_eye;        // metres; of the image's middle for parallel rays
uniform vec3 u_forward;    // unit vector
uniform vec3 u_right;      // from a pixel to its right neighbour: in lengths of u_forward (perspective) or metres
uniform vec3 u_down;       // from a pixel to the one below, likewise
uniform vec2 u_middle;     // of the image, pixels
uniform int u_perspective;
uniform int u_level;       // of detail; below 0: by Algo 1
uniform float u_max_anisotropy;
uniform int u_coarsest;    // level of detail

#define NOTHING_SEEN -1.0
#define UNDECIDED -2.0

// column, row (texels), depth (metres along the ray), level of detail or NOTHING_SEEN or UNDECIDED
layout(location = 0) out vec4 o_seen;

int level_at(GnomonHit hit, vec3 direction) {
  if (u_level >= 0) return u_level;
  GnomonMap map = pass_map();
  vec3 normal = gnomon_surface_normal(map, gnomon_receiver_at(hit.at.x, hit.at.y, 0.0), u_q);
  float apart = u_perspective != 0 ? hit.depth : 1.0;
  return gnomon_level_of_detail(gnomon_footprint(map, normal, direction, u_right * apart),
                                gnomon_footprint(map, normal, direction, u_down * apart), u_max_anisotropy, u_coarsest);
}

void main() {
  vec2 pixel = gl_FragCoord.xy + u_first_pixel - u_middle;
  vec3 aside = u_right * pixel.x + u_down * pixel.y;
  vec3 origin = u_perspective != 0 ? u_eye : u_eye + aside;
  vec3 direction = u_perspective != 0 ? u_forward + aside : u_forward;
  GnomonHit hit = gnomon_relief_view(pass_map(), origin, direction, u_q, u_step_limit);
  o_seen = vec4(hit.at, hit.depth * length(direction), NOTHING_SEEN);
  if (hit.cause == GNOMON_VIEW_SURFACE) o_seen.w = float(level_at(hit, direction));
  if (hit.cause == GNOMON_VIEW_UNDECIDED) o_seen.w = UNDECIDED;
}
