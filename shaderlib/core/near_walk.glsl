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

// The clearance where a ray leaves a patch that does not hide the receiver: not above it, whatever rounding says, but over
// a hole. A patch that the ray only touches changes nothing.
float gnomon_carried_clearance(GnomonCrossing crossing, float clearance, float crossed) {
  if (crossed <= 0.0f) return clearance;
  float left = gnomon_clearance_at(crossing, clearance, crossed);
  return crossing.hole ? left : min(left, 0.0f);
}

// Walks until t reaches 1 or the answer is known. The clearance starts at minus the receiver's height, exactly, and is
// carried from patch to patch: close to the receiver a difference of absolute heights would be all rounding. It is carried
// over a hole too, if the ray enters and leaves it over edges that have a surface: those meet in a corner, and between
// them gnomon_patch has the plane of three corners. A ray that leaves a hole for another one meets no surface before it
// has crossed a whole patch, where the clearance follows from the heights; the near walk ends there.
GnomonCursor gnomon_near_walk(GnomonRay ray, float receiver_height, int q) {
  GnomonCursor cursor = gnomon_cursor_at_start(ray);
  float clearance = -receiver_height;
  for (int i = 0; i < GNOMON_NEAR_PATCHES; ++i) {
    cursor.steps = i + 1;
    vec2 exits = gnomon_ray_exits(ray, cursor.patch_index, 0);
    float crossed = gnomon_crossed(ray, cursor.t, exits);
    GnomonCrossing crossing = gnomon_crossing(ray, cursor.patch_index, cursor.t, q);
    if (gnomon_crossing_hides(crossing, clearance, crossed)) {
      cursor.cause = GNOMON_CAUSE_SURFACE;
      return cursor;
    }
    clearance = gnomon_carried_clearance(crossing, clearance, crossed);
    bool second_hole = cursor.after_hole && crossing.hole;
    cursor = gnomon_leave_patch(ray, cursor, crossing, exits, GNOMON_NEVER);
    if (cursor.t >= 1.0f || second_hole || cursor.cause != GNOMON_CAUSE_UNDECIDED) return cursor;
  }
  return cursor;
}

#endif
