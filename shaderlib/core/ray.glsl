// SPDX-License-Identifier: MIT
// summary: A ray towards the sun over the patches of a height map: where it is, what it meets, where it goes next.
// source:  docs/algorithms.md, "multilevel"; eq. 3 and Algo 2 of Timokhin & Mikhaylyuk 2022 with errata c, f, g, i
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_CORE_RAY_GLSL
#define GNOMON_CORE_RAY_GLSL

#include <gnomon/core/height_map.glsl>
#include <gnomon/core/map.glsl>

// A t that no ray reaches.
#define GNOMON_NEVER 1e30f
// A component of the direction below this moves a ray by less than a millionth of a texel over any map.
#define GNOMON_NO_COMPONENT 1e-12f

// t counts texels along the axis on which the ray moves fastest. Heights are relative to `base`, so that single
// precision is spent on the relief and not on its altitude.
struct GnomonRay {
  ivec2 start;     // the patch in which the ray starts
  vec2 fraction;   // where in it, 0..1
  vec2 direction;  // patches per unit of t; the larger component is 1 or -1
  vec2 inverse;    // 1 / direction, large but finite where that is 0
  ivec2 forward;   // 1 where the ray moves east or south (or not at all), else 0
  float rise;      // metres per unit of t, > 0
  float base;      // metres: height of a corner of the start patch, the north-west one unless it is no sample
  float height;    // metres above base at t = 0
  float t_end;     // where the ray leaves the domain
};

// Heights of a patch above `base`: origin + slope.x * x + slope.y * y + twist * x * y for x, y in 0..1.
struct GnomonPatch {
  float origin;
  vec2 slope;
  float twist;
  bool hole;  // a corner is no sample: the patch has no surface
};

GnomonPatch gnomon_patch(ivec2 patch_index, float base, int q) {
  float north_west = gnomon_host_height(patch_index - ivec2(1, 1), q);
  float north_east = gnomon_host_height(patch_index - ivec2(0, 1), q);
  float south_west = gnomon_host_height(patch_index - ivec2(1, 0), q);
  float south_east = gnomon_host_height(patch_index, q);
  bool north = gnomon_is_sample(min(north_west, north_east));
  bool west = gnomon_is_sample(min(north_west, south_west));
  GnomonPatch result;
  result.hole = !(north && gnomon_is_sample(min(south_west, south_east)));
  result.origin = north_west - base;
  // Where one corner is no sample, the slopes are those of the plane through the other three: along the two edges that
  // have a surface, a walk carries its clearance over the hole (core/near_walk).
  result.slope = vec2(north ? north_east - north_west : south_east - south_west,
                      west ? south_west - north_west : south_east - north_east);
  result.twist = result.hole ? 0.0f : (south_east - south_west) - (north_east - north_west);
  return result;
}

float gnomon_patch_height(GnomonPatch p, vec2 at) {
  return p.origin + p.slope.x * at.x + at.y * (p.slope.y + p.twist * at.x);
}

// Moves a start on the patch's edge into the patch that the ray is about to cross, along one axis.
void gnomon_enter_patch(float direction, GNOMON_OUT(int) patch_index, GNOMON_OUT(float) fraction, int receiver_patch,
                        float receiver_fraction) {
  bool west_edge = direction < 0.0f && receiver_fraction <= 0.0f;
  bool east_edge = direction >= 0.0f && receiver_fraction >= 1.0f;
  patch_index = receiver_patch + (west_edge ? -1 : (east_edge ? 1 : 0));
  fraction = west_edge ? 1.0f : (east_edge ? 0.0f : receiver_fraction);
}

float gnomon_inverse(float direction) {
  return direction == 0.0f ? GNOMON_NEVER : 1.0f / direction;
}

// Where the ray leaves the domain along one axis, `ahead` patches (signed) from its start. A ray along the edge itself
// does not leave over it.
float gnomon_domain_exit(float ahead, float direction) {
  return direction == 0.0f ? GNOMON_NEVER : ahead / direction;
}

// Sets base and height. The start patch may have no surface where the receiver stands on its edge; corners away from that
// edge then have the weight 0. datum: metres, taken for the base where there is no corner at all.
GnomonRay gnomon_ray_from_ground(GnomonRay ray, float receiver_height, float datum, int q) {
  float north_west = gnomon_host_height(ray.start - ivec2(1, 1), q);
  float north_east = gnomon_host_height(ray.start - ivec2(0, 1), q);
  float south_west = gnomon_host_height(ray.start - ivec2(1, 0), q);
  float south_east = gnomon_host_height(ray.start, q);
  GnomonRay from = ray;
  float highest = max(max(north_west, north_east), max(south_west, south_east));
  from.base = gnomon_is_sample(north_west) ? north_west : (gnomon_is_sample(highest) ? highest : datum);
  GnomonPatch p = gnomon_patch(ray.start, from.base, q);
  vec2 far = ray.fraction;
  vec2 near = vec2(1.0f - far.x, 1.0f - far.y);
  float north = (north_west - from.base) * near.x + (north_east - from.base) * far.x;
  float south = (south_west - from.base) * near.x + (south_east - from.base) * far.x;
  from.height = receiver_height + (p.hole ? north * near.y + south * far.y : gnomon_patch_height(p, ray.fraction));
  return from;
}

// The ray from the receiver towards the sun, which stands above the plane and not at the zenith. Its height has a meaning
// where there is a surface (core/surface).
GnomonRay gnomon_ray(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q) {
  GnomonRay ray;
  vec2 texels = vec2(to_sun.x / map.spacing.x, -to_sun.y / map.spacing.y);
  float fastest = max(abs(texels.x), abs(texels.y));
  vec2 direction = vec2(texels.x / fastest, texels.y / fastest);
  if (abs(direction.x) < GNOMON_NO_COMPONENT) direction.x = 0.0f;
  if (abs(direction.y) < GNOMON_NO_COMPONENT) direction.y = 0.0f;
  ray.direction = direction;
  ray.inverse = vec2(gnomon_inverse(direction.x), gnomon_inverse(direction.y));
  ray.forward = ivec2(direction.x < 0.0f ? 0 : 1, direction.y < 0.0f ? 0 : 1);
  ray.rise = to_sun.z / fastest;

  int start_x = 0;
  int start_y = 0;
  float fraction_x = 0.0f;
  float fraction_y = 0.0f;
  gnomon_enter_patch(direction.x, start_x, fraction_x, receiver.patch_index.x, receiver.fraction.x);
  gnomon_enter_patch(direction.y, start_y, fraction_y, receiver.patch_index.y, receiver.fraction.y);
  ray.start = ivec2(start_x, start_y);
  ray.fraction = vec2(fraction_x, fraction_y);

  // The edge ahead in patches from the start patch; patch x begins half a texel west of sample x.
  float edge_x = (ray.forward.x == 1 ? map.domain.x + 0.5f : 0.5f) - float(start_x);
  float edge_y = (ray.forward.y == 1 ? map.domain.y + 0.5f : 0.5f) - float(start_y);
  ray.t_end = min(gnomon_domain_exit(edge_x - fraction_x, direction.x),
                  gnomon_domain_exit(edge_y - fraction_y, direction.y));
  return gnomon_ray_from_ground(ray, receiver.height, map.highest, q);
}

// Whether the ray runs along the edges of patches. The walk goes on their south or east side; an edge belongs to the
// patches on the other side too.
bool gnomon_ray_on_edges(GnomonRay ray) {
  return (ray.direction.x == 0.0f && ray.fraction.x == 0.0f) || (ray.direction.y == 0.0f && ray.fraction.y == 0.0f);
}

// The same ray as the other side of those edges has it.
GnomonRay gnomon_ray_other_side(GnomonRay ray) {
  GnomonRay other = ray;
  if (ray.direction.x == 0.0f && ray.fraction.x == 0.0f) {
    other.start.x = ray.start.x - 1;
    other.fraction.x = 1.0f;
    other.forward.x = 0;
    other.inverse.x = -GNOMON_NEVER;
  } else if (ray.direction.y == 0.0f && ray.fraction.y == 0.0f) {
    other.start.y = ray.start.y - 1;
    other.fraction.y = 1.0f;
    other.forward.y = 0;
    other.inverse.y = -GNOMON_NEVER;
  }
  return other;
}

// Where the ray leaves the block of 2^level x 2^level patches that begins at patch `low`, on each axis.
vec2 gnomon_ray_exits(GnomonRay ray, ivec2 low, int level) {
  ivec2 edge = low + ray.forward * (1 << level) - ray.start;
  return (vec2(edge) - ray.fraction) * ray.inverse;
}

// The patch that the ray enters when it leaves that block at `exits`. The axis that is crossed steps by integer index;
// the other one follows by floor, held inside the block and never against the ray's direction: rounding cannot turn
// the walk back or make it stand still (erratum g).
ivec2 gnomon_ray_next(GnomonRay ray, ivec2 current, ivec2 low, int level, vec2 exits) {
  float t = min(exits.x, exits.y);
  ivec2 high = low + ivec2((1 << level) - 1, (1 << level) - 1);
  ivec2 next = ray.start + ivec2(floor(ray.fraction + ray.direction * t));
  ivec2 nearest = ivec2(ray.forward.x == 1 ? current.x : low.x, ray.forward.y == 1 ? current.y : low.y);
  ivec2 farthest = ivec2(ray.forward.x == 1 ? high.x : current.x, ray.forward.y == 1 ? high.y : current.y);
  next = min(max(next, nearest), farthest);
  if (exits.x <= exits.y) next.x = ray.forward.x == 1 ? high.x + 1 : low.x - 1;
  if (exits.y <= exits.x) next.y = ray.forward.y == 1 ? high.y + 1 : low.y - 1;
  return next;
}

// The surface above the ray along a patch: clearance(s) = clearance + s * (slope + curvature * s), s = t - t_entry.
// Where the clearance is positive the receiver is hidden.
struct GnomonCrossing {
  float slope;
  float curvature;
  float above;  // metres: surface above `base` at the entry
  bool hole;    // there is no surface
};

GnomonCrossing gnomon_crossing(GnomonRay ray, ivec2 patch_index, float t, int q) {
  GnomonPatch p = gnomon_patch(patch_index, ray.base, q);
  vec2 entry = clamp(ray.fraction + (ray.direction * t - vec2(patch_index - ray.start)), vec2(0.0f, 0.0f), vec2(1.0f, 1.0f));
  GnomonCrossing crossing;
  crossing.above = gnomon_patch_height(p, entry);
  crossing.hole = p.hole;
  float rise_x = (p.slope.x + p.twist * entry.y) * ray.direction.x;
  float rise_y = (p.slope.y + p.twist * entry.x) * ray.direction.y;
  crossing.slope = rise_x + rise_y - ray.rise;
  crossing.curvature = p.twist * (ray.direction.x * ray.direction.y);
  return crossing;
}

float gnomon_clearance_at(GnomonCrossing crossing, float clearance, float s) {
  return clearance + s * (crossing.slope + crossing.curvature * s);
}

// Whether the surface rises strictly above the ray within 0 < s <= length, given its clearance at the entry: above 0 only
// where the surface begins there, beyond a hole. Exact: either an end is above, or the parabola's top lies inside and is.
// A clearance of exactly 0 (the receiver's own patch) needs no epsilon: the sign of the slope decides.
bool gnomon_crossing_hides(GnomonCrossing crossing, float clearance, float crossed) {
  if (crossing.hole || crossed <= 0.0f) return false;
  if (clearance > 0.0f) return true;
  if (gnomon_clearance_at(crossing, clearance, crossed) > 0.0f) return true;
  bool top_inside = crossing.curvature < 0.0f && crossing.slope > 0.0f && crossing.slope < -2.0f * crossing.curvature * crossed;
  return top_inside && crossing.slope * crossing.slope > 4.0f * crossing.curvature * clearance;
}

// How far the ray goes within a patch that it enters at t and leaves at `exits`.
float gnomon_crossed(GnomonRay ray, float t, vec2 exits) {
  return min(min(exits.x, exits.y), ray.t_end) - t;
}

// The clearance at t, far enough away for it to follow from the heights. after_hole: the patch before has no surface; else
// its exit was not above the ray, and neither is this entry, whatever rounding says.
float gnomon_far_clearance(GnomonRay ray, GnomonCrossing crossing, float t, bool after_hole) {
  float clearance = crossing.above - (ray.height + ray.rise * t);
  return after_hole ? clearance : min(clearance, 0.0f);
}

// Whether the surface hides the receiver within a patch far away that the ray enters at t and leaves at `exits`.
bool gnomon_far_patch_hides(GnomonRay ray, GnomonCrossing crossing, float t, vec2 exits, bool after_hole) {
  float clearance = gnomon_far_clearance(ray, crossing, t, after_hole);
  return gnomon_crossing_hides(crossing, clearance, gnomon_crossed(ray, t, exits));
}

#endif
