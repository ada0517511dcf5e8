// SPDX-License-Identifier: MIT
// summary: Exact hard shadow by looking at every patch under the ray.
// source:  docs/algorithms.md, "The oracle"; the same patch test as relief/multilevel, without a pyramid
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_BASELINE_BRUTE_FORCE_GLSL
#define GNOMON_BASELINE_BRUTE_FORCE_GLSL

#include <gnomon/core/near_walk.glsl>

// Whether the receiver is hidden from the sun. to_sun: unit vector, x east, y north, z up. step_limit: patches that may
// be visited, 8 * (width + height) always suffices; a ray that reaches it stays undecided.
GnomonShadow gnomon_brute_force(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, int step_limit) {
  GnomonShadow without_ray = gnomon_shadow_without_ray(to_sun);
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return without_ray;
  GnomonRay ray = gnomon_ray(map, receiver, to_sun, q);
  GnomonCursor cursor = gnomon_near_walk(ray, receiver.height, q);
  float t_above = gnomon_t_above(map, ray);
  for (int i = cursor.steps; i < step_limit; ++i) {
    if (cursor.cause != GNOMON_CAUSE_UNDECIDED) break;
    cursor.steps = i + 1;
    vec2 exits = gnomon_ray_exits(ray, cursor.patch_index, 0);
    if (gnomon_far_patch_hides(ray, cursor.patch_index, cursor.t, exits, q)) {
      cursor.cause = GNOMON_CAUSE_SURFACE;
    } else {
      cursor = gnomon_leave_block(ray, cursor, cursor.patch_index, 0, exits, t_above);
    }
  }
  return gnomon_walk_answer(cursor);
}

#endif
