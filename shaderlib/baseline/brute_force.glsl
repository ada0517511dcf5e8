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
  float t_above = ((map.highest - ray.base) - ray.height) / ray.rise;

  for (int i = cursor.steps; i < step_limit; ++i) {
    if (cursor.cause != GNOMON_CAUSE_UNDECIDED) break;
    cursor.steps = i + 1;
    vec2 exits = gnomon_ray_exits(ray, cursor.patch_index, 0);
    float t_exit = min(exits.x, exits.y);
    float crossed = min(t_exit, ray.t_end) - cursor.t;
    GnomonCrossing crossing = gnomon_crossing(ray, cursor.patch_index, cursor.t, q);
    float clearance = min(crossing.above - (ray.height + ray.rise * cursor.t), 0.0f);
    if (gnomon_crossing_hides(crossing, clearance, crossed)) {
      cursor.cause = GNOMON_CAUSE_SURFACE;
      break;
    }
    if (t_exit >= ray.t_end) cursor.cause = GNOMON_CAUSE_LEFT_MAP;
    if (t_exit >= t_above) cursor.cause = GNOMON_CAUSE_ABOVE_ALL;
    cursor.patch_index = gnomon_ray_next(ray, cursor.patch_index, cursor.patch_index, 0, exits);
    cursor.t = max(cursor.t, t_exit);
  }
  return gnomon_shadow(cursor.cause == GNOMON_CAUSE_SURFACE ? 1.0f : 0.0f, cursor.steps, cursor.cause);
}

#endif
