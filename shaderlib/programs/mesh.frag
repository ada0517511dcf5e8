// SPDX-License-Identifier: MIT
// What a camera sees of the relief drawn as a mesh: the same channels as view.frag.
#include <gnomon/host/r32f.glsl>
#include "mesh_pass.glsl"
#include "view_pass.glsl"

void main() {
  vec2 at = mesh_at();
  if (mesh_has_hole(at)) discard;
  float away = dot(v_place, u_forward);
  bool perspective = u_perspective != 0;
  float level = float(level_at(at, perspective ? v_place : u_forward, perspective ? away : 1.0));
  o_seen = vec4(at, perspective ? length(v_place) : away, level);
}
