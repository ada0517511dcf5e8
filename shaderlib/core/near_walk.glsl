// SPDX-License-Identifier: MIT
// summary: The first texel of a ray, patch by patch, without ever subtracting two heights that are nearly equal.
// source:  docs/algorithms.md, "Single precision"; errata e, f, i of Timokhin & Mikhaylyuk 2022
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_CORE_NEAR_WALK_GLSL
#define GNOMON_CORE_NEAR_WALK_GLSL

#include <gnomon/core/cursor.glsl>

// One texel along the ray crosses at most 3 patches on each axis, of which two may be left at the same t.
#define GNOMON_NEAR_PATCHES 6

// Walks until t reaches 1 or the answer is known. The clearance starts at minus the receiver's height, exactly, and is
// carried from patch to patch: close to the receiver a difference of absolute heights would be all rounding.
GnomonCursor gnomon_near_walk(GnomonRay ray, float receiver_height, int q) {
  GnomonCursor cursor;
  cursor.patch_index = ray.start;
  cursor.t = 0.0f;
  cursor.steps = 0;
  cursor.cause = GNOMON_CAUSE_UNDECIDED;
  float clearance = -receiver_height;
  for (int i = 0; i < GNOMON_NEAR_PATCHES; ++i) {
    cursor.steps = i + 1;
    vec2 exits = gnomon_ray_exits(ray, cursor.patch_index, 0);
    float crossed = min(min(exits.x, exits.y), ray.t_end) - cursor.t;
    GnomonCrossing crossing = gnomon_crossing(ray, cursor.patch_index, cursor.t, q);
    if (gnomon_crossing_hides(crossing, clearance, crossed)) {
      cursor.cause = GNOMON_CAUSE_SURFACE;
      return cursor;
    }
    clearance = crossed > 0.0f ? min(gnomon_clearance_at(crossing, clearance, crossed), 0.0f) : clearance;
    cursor = gnomon_leave_block(ray, cursor, cursor.patch_index, 0, exits, GNOMON_NEVER);
    if (cursor.t >= 1.0f || cursor.cause != GNOMON_CAUSE_UNDECIDED) return cursor;
  }
  return cursor;
}

#endif
