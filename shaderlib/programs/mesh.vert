// SPDX-License-Identifier: MIT
// The relief as a mesh before a camera: an instance a row of cells, each a strip of triangles.
#include <gnomon/host/r32f.glsl>
#include <gnomon/mesh/grid.glsl>
#include "camera_pass.glsl"

uniform int u_grid_step;
uniform ivec2 u_first_node;  // of the part of the grid that is drawn
uniform vec2 u_tile_size;  // pixels
uniform float u_near;      // metres along u_forward, perspective
uniform float u_far;       // metres along u_forward, parallel rays

layout(location = 0) out vec2 v_at;     // column and row in texels of the level
layout(location = 1) out vec3 v_place;  // metres from the eye
layout(location = 2) out float v_hole;  // above 0 in triangles with a node that has no surface

void main() {
  ivec2 node = u_first_node + ivec2(gl_VertexID >> 1, gl_InstanceID + (gl_VertexID & 1));
  GnomonMap map = pass_map();
  v_at = vec2(gnomon_grid_coordinate(node.x, map.size.x, map.domain.x, u_grid_step),
              gnomon_grid_coordinate(node.y, map.size.y, map.domain.y, u_grid_step));
  float height = gnomon_grid_height(v_at.x, v_at.y, u_q);
  v_hole = gnomon_is_sample(height) ? 0.0 : 1.0;
  if (v_hole > 0.0) height = map.highest;
  v_place = vec3(v_at.x * map.spacing.x, (map.domain.y - v_at.y) * map.spacing.y, height) - u_eye;
  // Rows of the image go down, and so do window coordinates here. Depth is 1 at u_near and falls with the distance.
  float away = dot(v_place, u_forward);
  float w = u_perspective != 0 ? away : 1.0;
  vec2 aside = vec2(dot(v_place, u_right) / dot(u_right, u_right), dot(v_place, u_down) / dot(u_down, u_down));
  vec2 pixel = aside + (u_middle - u_first_pixel) * w;
  float nearness = u_perspective != 0 ? u_near : 1.0 - away / u_far;
  gl_Position = vec4(2.0 * pixel / u_tile_size - w, nearness, w);
}
