// SPDX-License-Identifier: MIT
// summary: Where a walk along a ray stands, and its step to the next patch or block.
// source:  docs/algorithms.md, "multilevel"; Algo 2 of Timokhin & Mikhaylyuk 2022 with erratum g
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_CORE_CURSOR_GLSL
#define GNOMON_CORE_CURSOR_GLSL

#include <gnomon/core/ray.glsl>
#include <gnomon/core/shadow.glsl>

struct GnomonCursor {
  ivec2 patch_index;  // the patch to look at next
  float t;            // where the ray enters it
  int steps;          // patches and blocks visited so far
  int cause;          // GNOMON_CAUSE_UNDECIDED while the walk goes on
  bool after_hole;    // the patch that the ray has just left has no surface
  bool met_hole;      // nor had some patch on its way
};

GnomonCursor gnomon_cursor_at_start(GnomonRay ray) {
  GnomonCursor cursor;
  cursor.patch_index = ray.start;
  cursor.t = 0.0f;
  cursor.steps = 0;
  cursor.cause = GNOMON_CAUSE_UNDECIDED;
  cursor.after_hole = false;
  cursor.met_hole = false;
  return cursor;
}

// Leaves the block of 2^level x 2^level patches that begins at `low`, where `exits` says. The walk ends where the ray
// leaves the domain or rises above every sample, at t_above.
GnomonCursor gnomon_leave_block(GnomonRay ray, GnomonCursor cursor, ivec2 low, int level, vec2 exits, float t_above) {
  float t_exit = min(exits.x, exits.y);
  GnomonCursor next = cursor;
  if (t_exit >= ray.t_end) next.cause = GNOMON_CAUSE_LEFT_MAP;
  if (t_exit >= t_above) next.cause = GNOMON_CAUSE_ABOVE_ALL;
  next.patch_index = gnomon_ray_next(ray, cursor.patch_index, low, level, exits);
  next.t = max(cursor.t, t_exit);
  next.after_hole = false;  // whatever this block holds, and its edges with it, lies below the ray
  return next;
}

// Leaves a patch in which nothing hides the receiver. One that the ray only touches changes nothing.
GnomonCursor gnomon_leave_patch(GnomonRay ray, GnomonCursor cursor, GnomonCrossing crossing, vec2 exits, float t_above) {
  bool touched = gnomon_crossed(ray, cursor.t, exits) <= 0.0f;
  GnomonCursor next = gnomon_leave_block(ray, cursor, cursor.patch_index, 0, exits, t_above);
  next.after_hole = crossing.hole || (touched && cursor.after_hole);
  next.met_hole = crossing.hole || cursor.met_hole;
  return next;
}

// Whether the walk has to be repeated on the other side of the edges that the ray runs along: it met no surface, but
// missed some, where only patches on that side have one.
bool gnomon_repeat_on_other_side(GnomonRay ray, GnomonCursor cursor) {
  bool lit = cursor.cause == GNOMON_CAUSE_LEFT_MAP || cursor.cause == GNOMON_CAUSE_ABOVE_ALL;
  return lit && cursor.met_hole && gnomon_ray_on_edges(ray);
}

// Where the ray rises above the highest sample of the map.
float gnomon_t_above(GnomonMap map, GnomonRay ray) {
  return ((map.highest - ray.base) - ray.height) / ray.rise;
}

// The answer that a walk came to.
GnomonShadow gnomon_walk_answer(GnomonCursor cursor) {
  return gnomon_shadow(cursor.cause == GNOMON_CAUSE_SURFACE ? 1.0f : 0.0f, cursor.steps, cursor.cause);
}

#endif
