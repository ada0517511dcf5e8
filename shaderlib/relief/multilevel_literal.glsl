// SPDX-License-Identifier: MIT
// summary: Hard shadow by the papers' own text, wrong where the text is: to see what it does. Use relief/multilevel.
// source:  Algo 3 and eq. 2 of Timokhin & Mikhaylyuk 2022; only errata c, g, h, k, l, m are put right: docs/errata.md
// host:    gnomon_host_height, gnomon_host_literal_extrema
// options: none
#ifndef GNOMON_RELIEF_MULTILEVEL_LITERAL_GLSL
#define GNOMON_RELIEF_MULTILEVEL_LITERAL_GLSL

#include <gnomon/core/ray.glsl>
#include <gnomon/core/shadow.glsl>
#include <gnomon/relief/literal_extrema.glsl>
#include <gnomon/relief/transit.glsl>

// More levels than a map can have.
#define GNOMON_LITERAL_LEVELS 32

// What a look at a texel or block says.
#define GNOMON_LITERAL_PASS 0     // nothing here rises to the ray: go on to the next
#define GNOMON_LITERAL_DESCEND 1  // look closer
#define GNOMON_LITERAL_SURFACE 2  // shadow
#define GNOMON_LITERAL_MINIMUM 3  // shadow: already the lowest of the block rises to the ray

// P, a point of the relief from which the ray goes towards the sun, and its track s'.
struct GnomonTrack {
  vec2 start;      // P', in texels of H_q
  float height;    // metres
  vec2 direction;  // u, a unit vector in texels
  vec3 to_sun;     // s
};

// Eq. 2: the flag b_shadow for v, from P to a point of the relief. p <= 0 as printed, so grazing counts (erratum i).
bool gnomon_literal_flag(vec3 v, vec3 to_sun) {
  vec3 up = vec3(0.0f, 0.0f, 1.0f);
  vec3 r = cross(to_sun, up);
  float p = dot(r, cross(v, to_sun));
  return p <= 0.0f && dot(to_sun, up) != 1.0f;
}

// Whether a point `height` metres high above `at` would hide P from the sun.
bool gnomon_literal_hides(GnomonMap map, GnomonTrack track, vec2 at, float height) {
  float east = (at.x - track.start.x) * map.spacing.x;
  float north = (track.start.y - at.y) * map.spacing.y;
  return gnomon_literal_flag(vec3(east, north, height - track.height), track.to_sun);
}

// The surface of H_q at a place in texels, metres: bilinear. GNOMON_NO_SAMPLE, far below everything, in a hole.
float gnomon_literal_height(vec2 at, int q) {
  GnomonReceiver place = gnomon_receiver_at(at.x, at.y, 0.0f);
  GnomonPatch p = gnomon_patch(place.patch_index, 0.0f, q);
  return p.hole ? GNOMON_NO_SAMPLE : gnomon_patch_height(p, place.fraction);
}

GnomonTrack gnomon_literal_track(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q) {
  GnomonTrack track;
  track.start = vec2(receiver.patch_index) + (receiver.fraction - vec2(0.5f, 0.5f));
  track.height = gnomon_literal_height(track.start, q) + receiver.height;
  vec2 texels = vec2(to_sun.x / map.spacing.x, -to_sun.y / map.spacing.y);
  // By the larger component first: a sun next to the zenith would have a length of 0.
  float fastest = max(abs(texels.x), abs(texels.y));
  vec2 direction = vec2(texels.x / fastest, texels.y / fastest);
  float size = sqrt(direction.x * direction.x + direction.y * direction.y);
  track.direction = vec2(direction.x / size, direction.y / size);
  track.to_sun = to_sun;
  return track;
}

// A texel of H_q (level == q) by one sample in the middle of the way through it, or a block of H_ext by its extrema,
// both compared where the track leaves it (errata b, f, o).
int gnomon_literal_look(GnomonMap map, GnomonTrack track, vec2 entry, vec2 exit_point, ivec2 block, int level, int q) {
  if (level == q) {
    vec2 middle = (entry + exit_point) * 0.5f;
    bool hidden = gnomon_literal_hides(map, track, middle, gnomon_literal_height(middle, q));
    return hidden ? GNOMON_LITERAL_SURFACE : GNOMON_LITERAL_PASS;
  }
  vec2 extrema = gnomon_host_literal_extrema(block, level);
  if (gnomon_literal_hides(map, track, exit_point, extrema.y)) return GNOMON_LITERAL_MINIMUM;
  return gnomon_literal_hides(map, track, exit_point, extrema.x) ? GNOMON_LITERAL_DESCEND : GNOMON_LITERAL_PASS;
}

// What the papers answer. map.top_level: coarsest level of gnomon_host_literal_extrema, 0 where it has none. step_limit:
// texels and blocks that may be left behind, 2 * (width + height) always suffices; `steps` counts every look, the
// descents included. The start is the listing's (erratum n): level q first, then each time the coarsest that there is.
GnomonShadow gnomon_multilevel_literal(GnomonMap map, GnomonReceiver receiver, vec3 to_sun, int q, int step_limit) {
  GnomonShadow answer = gnomon_shadow_without_ray(to_sun);
  if (answer.cause != GNOMON_CAUSE_UNDECIDED) return answer;
  GnomonTrack track = gnomon_literal_track(map, receiver, to_sun, q);
  int coarsest = max(q, map.top_level);
  // The texel of the receiver is left without a look (erratum e).
  ivec2 current = ivec2(floor(track.start));
  GnomonTransit transit = gnomon_transit(track.start, current, 1, track.direction);
  vec2 entry = track.start + track.direction * transit.t;
  current = gnomon_transit_next(transit, entry, current, current, 1, track.direction);
  int level = q;
  for (int left = 0; left < step_limit; ++left) {
    bool inside = current.x >= 0 && current.y >= 0 && current.x < map.size.x && current.y < map.size.y;
    if (!inside) return gnomon_shadow(0.0f, answer.steps, GNOMON_CAUSE_LEFT_MAP);
    ivec2 low = current;
    vec2 exit_point = entry;
    int seen = GNOMON_LITERAL_DESCEND;
    for (int i = 0; i < GNOMON_LITERAL_LEVELS; ++i) {
      answer.steps += 1;
      ivec2 block = current >> (level - q);
      low = block << (level - q);
      transit = gnomon_transit(entry, low, 1 << (level - q), track.direction);
      exit_point = entry + track.direction * transit.t;
      seen = gnomon_literal_look(map, track, entry, exit_point, block, level, q);
      if (seen != GNOMON_LITERAL_DESCEND) break;
      level -= 1;
    }
    if (seen == GNOMON_LITERAL_SURFACE) return gnomon_shadow(1.0f, answer.steps, GNOMON_CAUSE_SURFACE);
    if (seen == GNOMON_LITERAL_MINIMUM) return gnomon_shadow(1.0f, answer.steps, GNOMON_CAUSE_BELOW_BLOCK);
    current = gnomon_transit_next(transit, exit_point, current, low, 1 << (level - q), track.direction);
    entry = exit_point;
    level = coarsest;
  }
  return answer;
}

#endif
