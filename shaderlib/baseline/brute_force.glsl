// SPDX-License-Identifier: MIT
// summary: Exact hard shadow by looking at every patch under the ray.
// source:  docs/algorithms.md, "The oracle"; the same patch test as relief/multilevel, without a pyramid
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_BASELINE_BRUTE_FORCE_GLSL
#define GNOMON_BASELINE_BRUTE_FORCE_GLSL

#include <gnomon/core/near_walk.glsl>

// Whether the receiver, which has a surface under it (core/surface), is hidden from the sun. to_sun: unit vector, x east,
// y north, z up. step_limit: patches that may be visited, 8 * (width + height) always suffices; a ray that reaches it
// stays undecided.
GnomonShadow gnomon_brute_force(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, int step_limit) {
  GnomonShadow without_ray = gnomon_shadow_without_ray(to_sun);
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return without_ray;
  GnomonRay ray = gnomon_ray(map, receiver, to_sun, q);
  float t_above = gnomon_t_above(map, ray);
  GnomonCursor cursor = gnomon_cursor_at_start(ray);
  for (int side = 0; side < 2; ++side) {
    int steps = cursor.steps;
    cursor = gnomon_near_walk(ray, receiver.height, q);
    cursor.steps += steps;
    for (int i = cursor.steps; i < step_limit; ++i) {
      if (cursor.cause != GNOMON_CAUSE_UNDECIDED) break;
      cursor.steps = i + 1;
      vec2 exits = gnomon_ray_exits(ray, cursor.patch_index, 0);
      GnomonCrossing crossing = gnomon_crossing(ray, cursor.patch_index, cursor.t, q);
      if (gnomon_far_patch_hides(ray, crossing, cursor.t, exits, cursor.after_hole)) {
        cursor.cause = GNOMON_CAUSE_SURFACE;
      } else {
        cursor = gnomon_leave_patch(ray, cursor, crossing, exits, t_above);
      }
    }
    if (!gnomon_repeat_on_other_side(ray, cursor)) break;
    ray = gnomon_ray_other_side(ray);
  }
  return gnomon_walk_answer(cursor);
}

#endif
