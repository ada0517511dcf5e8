// SPDX-License-Identifier: MIT
// summary: Exact hard shadow by walking a pyramid of patch maxima.
// source:  docs/algorithms.md, "multilevel"; corrects Algo 3 of Timokhin & Mikhaylyuk 2022
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_RELIEF_MULTILEVEL_GLSL
#define GNOMON_RELIEF_MULTILEVEL_GLSL

#include <gnomon/core/near_walk.glsl>
#include <gnomon/relief/climb.glsl>

// Whether the receiver is hidden from the sun. to_sun: unit vector, x east, y north, z up. step_limit: blocks and
// patches that may be visited, 8 * (width + height) always suffices; a ray that reaches it stays undecided.
GnomonShadow gnomon_multilevel(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, int step_limit) {
  GnomonShadow without_ray = gnomon_shadow_without_ray(to_sun);
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return without_ray;
  GnomonRay ray = gnomon_ray(map, receiver, to_sun, q);
  GnomonCursor cursor = gnomon_near_walk(ray, receiver.height, q);
  float t_above = gnomon_t_above(map, ray);
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
    if (gnomon_far_patch_hides(ray, left, cursor.t, exits, q)) {
      cursor.cause = GNOMON_CAUSE_SURFACE;
      break;
    }
    cursor = gnomon_leave_block(ray, cursor, left, 0, exits, t_above);
    level = gnomon_climb(left, cursor.patch_index, 0, map.top_level);
  }
  return gnomon_walk_answer(cursor);
}

#endif
