// SPDX-License-Identifier: MIT
// summary: Exact hard shadow by walking a pyramid of patch maxima.
// source:  docs/algorithms.md, "multilevel"; corrects Algo 3 of Timokhin & Mikhaylyuk 2022
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_RELIEF_MULTILEVEL_GLSL
#define GNOMON_RELIEF_MULTILEVEL_GLSL

#include <gnomon/core/near_walk.glsl>
#include <gnomon/relief/climb.glsl>

// Goes on from where the near walk ended until the answer is known or `step_limit` is reached.
GnomonCursor gnomon_far_walk(GnomonMap map, GnomonRay ray, GnomonCursor start, float t_above, int q, int step_limit) {
  GnomonCursor cursor = start;
  int level = 1;
  for (int leaf = 0; leaf < step_limit; ++leaf) {
    // Blocks until a patch is reached, then that patch: hardware that runs pixels in lockstep pays for both kinds of step
    // in a loop that mixes them.
    for (int i = cursor.steps; i < step_limit; ++i) {
      if (level == 0 || cursor.cause != GNOMON_CAUSE_UNDECIDED) break;
      cursor.steps = i + 1;
      ivec2 block = cursor.patch_index >> level;
      // Compared where the ray enters: it only rises from there (erratum b).
      if (gnomon_host_extrema(block, level, q) - ray.base > ray.height + ray.rise * cursor.t) {
        level -= 1;
      } else {
        ivec2 left = cursor.patch_index;
        ivec2 low = block << level;
        cursor = gnomon_leave_block(ray, cursor, low, level, gnomon_ray_exits(ray, low, level), t_above);
        level = gnomon_climb(left, cursor.patch_index, level, map.top_level);
      }
    }
    if (cursor.cause != GNOMON_CAUSE_UNDECIDED || cursor.steps >= step_limit) break;
    cursor.steps += 1;
    ivec2 left = cursor.patch_index;
    vec2 exits = gnomon_ray_exits(ray, left, 0);
    GnomonCrossing crossing = gnomon_crossing(ray, left, cursor.t, q);
    if (gnomon_far_patch_hides(ray, crossing, cursor.t, exits, cursor.after_hole)) {
      cursor.cause = GNOMON_CAUSE_SURFACE;
      break;
    }
    cursor = gnomon_leave_patch(ray, cursor, crossing, exits, t_above);
    level = gnomon_climb(left, cursor.patch_index, 0, map.top_level);
  }
  return cursor;
}

// Whether the receiver, which has a surface under it (core/surface), is hidden from the sun. to_sun: unit vector, x east,
// y north, z up. step_limit: blocks and patches that may be visited, 8 * (width + height) always suffices; a ray that
// reaches it stays undecided.
GnomonShadow gnomon_multilevel(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, int step_limit) {
  GnomonShadow without_ray = gnomon_shadow_without_ray(to_sun);
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return without_ray;
  GnomonRay ray = gnomon_ray(map, receiver, to_sun, q);
  float t_above = gnomon_t_above(map, ray);
  GnomonCursor cursor = gnomon_cursor_at_start(ray);
  // Once; for a ray along edges that met a hole twice.
  for (int side = 0; side < 2; ++side) {
    int steps = cursor.steps;
    cursor = gnomon_near_walk(ray, receiver.height, q);
    cursor.steps += steps;
    cursor = gnomon_far_walk(map, ray, cursor, t_above, q, step_limit);
    if (!gnomon_repeat_on_other_side(ray, cursor)) break;
    ray = gnomon_ray_other_side(ray);
  }
  return gnomon_walk_answer(cursor);
}

#endif
