// SPDX-License-Identifier: MIT
// summary: Where a view ray first dives under the relief: the surface itself, without a mesh.
// source:  docs/algorithms.md, "View rays"; the walk of "multilevel", turned downward
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_VIEW_RELIEF_VIEW_GLSL
#define GNOMON_VIEW_RELIEF_VIEW_GLSL

#include <gnomon/core/surface.glsl>
#include <gnomon/relief/climb.glsl>

// Why a view ray ended. One that reaches its step limit stays undecided: that is an error to report, never sky.
#define GNOMON_VIEW_UNDECIDED 0
#define GNOMON_VIEW_SURFACE 1
#define GNOMON_VIEW_SKY 2

// A ray that moves less than this many texels for each metre of height is taken for vertical.
#define GNOMON_VERTICAL 1e-9f

struct GnomonHit {
  vec2 at;      // column and row in texels of the level
  float depth;  // along the ray, in lengths of its direction; 0 where it meets nothing
  int steps;    // blocks and patches that the ray visited
  int cause;    // GNOMON_VIEW_...
};

GnomonHit gnomon_hit(vec2 at, float depth, int steps, int cause) {
  GnomonHit hit;
  hit.at = at;
  hit.depth = depth;
  hit.steps = steps;
  hit.cause = cause;
  return hit;
}

// The part of a ray that lies over the domain, at or below the highest sample. Parameters in lengths of the direction.
struct GnomonSpan {
  float first;
  float last;
};

// Cuts a span down to where origin + t * direction lies in low .. high.
GnomonSpan gnomon_cut_span(GnomonSpan span, float origin, float direction, float low, float high) {
  GnomonSpan result = span;
  if (direction == 0.0f) {
    if (origin < low || origin > high) result.last = -1.0f;
    return result;
  }
  float a = (low - origin) / direction;
  float b = (high - origin) / direction;
  result.first = max(span.first, min(a, b));
  result.last = min(span.last, max(a, b));
  return result;
}

// The root of clearance + s * (slope + curvature * s) at which it grows: where a ray dives under the surface. `root` is
// the square root of the discriminant. The form that does not cancel.
float gnomon_dive_root(GnomonCrossing crossing, float clearance, float root) {
  return crossing.slope > 0.0f ? -2.0f * clearance / (crossing.slope + root)
                               : (root - crossing.slope) / (2.0f * crossing.curvature);
}

// Where in 0..crossed the ray dives under the surface of a patch, given the clearance (surface above the ray) at the
// entry; GNOMON_NEVER where it does not. `above`: whether the ray was above the surface when it left the patch before;
// rounding at the common edge opens no gap.
float gnomon_dive(GnomonCrossing crossing, float clearance, float crossed, bool above) {
  if (crossing.hole) return GNOMON_NEVER;
  if (above && clearance > 0.0f) return 0.0f;
  float root = sqrt(max(crossing.slope * crossing.slope - 4.0f * crossing.curvature * clearance, 0.0f));
  if (clearance <= 0.0f) {
    if (!gnomon_crossing_hides(crossing, clearance, crossed)) return GNOMON_NEVER;
    return clamp(gnomon_dive_root(crossing, clearance, root), 0.0f, crossed);
  }
  // From under the surface: up through it, and down again.
  if (crossing.curvature <= 0.0f || crossing.slope >= 0.0f || root == 0.0f) return GNOMON_NEVER;
  float again = gnomon_dive_root(crossing, clearance, root);
  return again <= crossed ? again : GNOMON_NEVER;
}

// The walk of a view ray: at `t` in a patch, above the surface or under it. Where it comes from a hole, the side on which
// it enters says so anew: a sheet that begins above the ray is seen from under it, and not seen.
GnomonHit gnomon_view_walk(GnomonMap map, GnomonRay ray, bool starts_above, int q, int step_limit) {
  GnomonCursor cursor = gnomon_cursor_at_start(ray);
  bool above = starts_above;
  int level = 0;
  for (int i = 0; i < step_limit; ++i) {
    cursor.steps = i + 1;
    ivec2 left = cursor.patch_index;
    ivec2 low = (left >> level) << level;
    vec2 exits = gnomon_ray_exits(ray, low, level);
    float t_exit = min(min(exits.x, exits.y), ray.t_end);
    bool over_hole = false;
    if (level > 0) {
      float lowest = ray.height + ray.rise * (ray.rise < 0.0f ? t_exit : cursor.t);
      if (gnomon_host_extrema(left >> level, level, q) - ray.base > lowest) {
        level -= 1;
        continue;
      }
      above = true;
    } else {
      GnomonCrossing crossing = gnomon_crossing(ray, left, cursor.t, q);
      float clearance = crossing.above - (ray.height + ray.rise * cursor.t);
      float crossed = max(t_exit - cursor.t, 0.0f);
      if (cursor.after_hole) above = clearance <= 0.0f;
      float dive = gnomon_dive(crossing, clearance, crossed, above);
      if (dive < GNOMON_NEVER) {
        float t = cursor.t + dive;
        vec2 patches = ray.fraction + ray.direction * t;
        vec2 at = vec2(ray.start) - vec2(0.5f, 0.5f) + patches;
        return gnomon_hit(clamp(at, vec2(0.0f, 0.0f), map.domain), t, cursor.steps, GNOMON_VIEW_SURFACE);
      }
      above = gnomon_clearance_at(crossing, clearance, crossed) <= 0.0f;
      over_hole = crossing.hole || (cursor.after_hole && crossed <= 0.0f);
    }
    cursor = gnomon_leave_block(ray, cursor, low, level, exits, GNOMON_NEVER);
    cursor.after_hole = over_hole;
    if (cursor.cause != GNOMON_CAUSE_UNDECIDED) return gnomon_hit(vec2(0.0f, 0.0f), 0.0f, cursor.steps, GNOMON_VIEW_SKY);
    level = gnomon_climb(left, cursor.patch_index, level, map.top_level);
  }
  return gnomon_hit(vec2(0.0f, 0.0f), 0.0f, step_limit, GNOMON_VIEW_UNDECIDED);
}

// The point of the surface of level q that a ray from `origin` (metres: x east, y north of the domain's south-west
// corner, z up) sees along `direction` (any length). The surface is seen from above: a ray that begins, or enters the
// domain, under it sees nothing; to follow it until it comes out would cost a step for every patch, and no camera stands
// there. step_limit: as for the shadow methods.
GnomonHit gnomon_relief_view(GnomonMap map, vec3 origin, vec3 direction, int q, int step_limit) {
  GnomonHit sky = gnomon_hit(vec2(0.0f, 0.0f), 0.0f, 0, GNOMON_VIEW_SKY);
  vec2 start = vec2(origin.x / map.spacing.x, map.domain.y - origin.y / map.spacing.y);
  vec2 texels = vec2(direction.x / map.spacing.x, -direction.y / map.spacing.y);
  GnomonSpan span;
  span.first = 0.0f;
  span.last = GNOMON_NEVER;
  span = gnomon_cut_span(span, start.x, texels.x, 0.0f, map.domain.x);
  span = gnomon_cut_span(span, start.y, texels.y, 0.0f, map.domain.y);
  span = gnomon_cut_span(span, origin.z, direction.z, -GNOMON_NEVER, map.highest);
  if (span.first > span.last) return sky;

  vec2 over = clamp(start + texels * span.first, vec2(0.0f, 0.0f), map.domain);
  GnomonReceiver foot = gnomon_receiver_at(over.x, over.y, 0.0f);
  float fastest = max(abs(texels.x), abs(texels.y));
  if (fastest <= GNOMON_VERTICAL * abs(direction.z)) {
    GnomonReceiver on = gnomon_on_surface(foot, q);
    float base = gnomon_host_height(on.patch_index, q);
    GnomonPatch under = gnomon_patch(on.patch_index, base, q);
    float fall = (origin.z - base) - gnomon_patch_height(under, on.fraction);
    bool sees = direction.z < 0.0f && fall >= 0.0f && !under.hole;
    return sees ? gnomon_hit(over, fall / -direction.z, 1, GNOMON_VIEW_SURFACE) : sky;
  }
  GnomonRay ray = gnomon_ray(map, foot, direction, q);
  bool over_hole = !gnomon_has_surface(foot, q);
  float ground = ray.height;
  ray.height = (origin.z - ray.base) + direction.z * span.first;
  ray.t_end = min(ray.t_end, (span.last - span.first) * fastest);
  if (!over_hole && ground > ray.height) return sky;
  GnomonHit hit = gnomon_view_walk(map, ray, true, q, step_limit);
  hit.depth = hit.cause == GNOMON_VIEW_SURFACE ? span.first + hit.depth / fastest : 0.0f;
  return hit;
}

#endif
