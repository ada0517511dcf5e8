// SPDX-License-Identifier: MIT
// summary: Exact hard shadow by walking a pyramid of patch maxima.
// source:  docs/algorithms.md, "multilevel"; corrects Algo 3 of Timokhin & Mikhaylyuk 2022
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_RELIEF_MULTILEVEL_GLSL
#define GNOMON_RELIEF_MULTILEVEL_GLSL

#include <gnomon/core/near_walk.glsl>

// Whether the receiver is hidden from the sun. to_sun: unit vector, x east, y north, z up. step_limit: blocks and
// patches that may be visited, 8 * (width + height) always suffices; a ray that reaches it stays undecided.
GnomonShadow gnomon_multilevel(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, int step_limit) {
  GnomonShadow without_ray = gnomon_shadow_without_ray(to_sun);
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return without_ray;
  GnomonRay ray = gnomon_ray(map, receiver, to_sun, q);
  GnomonCursor cursor = gnomon_near_walk(ray, receiver.height, q);
  float t_above = ((map.highest - ray.base) - ray.height) / ray.rise;

  int level = 1;
  for (int i = cursor.steps; i < step_limit; ++i) {
    if (cursor.cause != GNOMON_CAUSE_UNDECIDED) break;
    cursor.steps = i + 1;
    ivec2 block = cursor.patch_index >> level;
    ivec2 low = block << level;
    float ray_height = ray.height + ray.rise * cursor.t;
    // Compared where the ray enters: it only rises from there (erratum b).
    if (level > 0 && gnomon_host_extrema(block, level, q) - ray.base > ray_height) {
      level -= 1;
      continue;
    }
    vec2 exits = gnomon_ray_exits(ray, low, level);
    float t_exit = min(exits.x, exits.y);
    if (level == 0) {
      GnomonCrossing crossing = gnomon_crossing(ray, cursor.patch_index, cursor.t, q);
      float crossed = min(t_exit, ray.t_end) - cursor.t;
      if (gnomon_crossing_hides(crossing, min(crossing.above - ray_height, 0.0f), crossed)) {
        cursor.cause = GNOMON_CAUSE_SURFACE;
        break;
      }
    }
    if (t_exit >= ray.t_end) cursor.cause = GNOMON_CAUSE_LEFT_MAP;
    if (t_exit >= t_above) cursor.cause = GNOMON_CAUSE_ABOVE_ALL;
    ivec2 next = gnomon_ray_next(ray, cursor.patch_index, low, level, exits);
    ivec2 left = (next >> (level + 1)) ^ (cursor.patch_index >> (level + 1));
    if ((left.x | left.y) != 0) level = min(level + 1, map.top_level);
    cursor.patch_index = next;
    cursor.t = max(cursor.t, t_exit);
  }
  return gnomon_shadow(cursor.cause == GNOMON_CAUSE_SURFACE ? 1.0f : 0.0f, cursor.steps, cursor.cause);
}

#endif
