// SPDX-License-Identifier: MIT
// What a perspective or orthographic camera sees of the relief: where on the map, how far away, at which level.
#include <gnomon/host/r32f.glsl>
#include <gnomon/view/relief_view.glsl>
#include "view_pass.glsl"

void main() {
  vec2 pixel = gl_FragCoord.xy + u_first_pixel - u_middle;
  vec3 aside = u_right * pixel.x + u_down * pixel.y;
  vec3 origin = u_perspective != 0 ? u_eye : u_eye + aside;
  vec3 direction = u_perspective != 0 ? u_forward + aside : u_forward;
  GnomonHit hit = gnomon_relief_view(pass_map(), origin, direction, u_q, u_step_limit);
  o_seen = vec4(hit.at, hit.depth * length(direction), NOTHING_SEEN);
  float apart = u_perspective != 0 ? hit.depth : 1.0;
  if (hit.cause == GNOMON_VIEW_SURFACE) o_seen.w = float(level_at(hit.at, direction, apart));
  if (hit.cause == GNOMON_VIEW_UNDECIDED) o_seen.w = UNDECIDED;
}
