// SPDX-License-Identifier: MIT
// What a perspective or orthographic camera sees of the relief: where on the map, and how far away.
#include <gnomon/host/r32f.glsl>
#include <gnomon/view/relief_view.glsl>
#include "map_pass.glsl"

uniform vec3 u_eye;        // metres; of the image's middle for parallel rays
uniform vec3 u_forward;    // unit vector
uniform vec3 u_right;      // from a pixel to its right neighbour: in lengths of u_forward (perspective) or metres
uniform vec3 u_down;       // from a pixel to the one below, likewise
uniform vec2 u_middle;     // of the image, pixels
uniform int u_perspective;

// column, row (texels), depth (metres along the ray, 0 for sky), cause (GNOMON_VIEW_...)
layout(location = 0) out vec4 o_seen;

void main() {
  vec2 pixel = gl_FragCoord.xy + u_first_pixel - u_middle;
  vec3 aside = u_right * pixel.x + u_down * pixel.y;
  vec3 origin = u_perspective != 0 ? u_eye : u_eye + aside;
  vec3 direction = u_perspective != 0 ? u_forward + aside : u_forward;
  GnomonHit hit = gnomon_relief_view(pass_map(), origin, direction, u_q, u_step_limit);
  o_seen = vec4(hit.at, hit.depth * length(direction), float(hit.cause));
}
