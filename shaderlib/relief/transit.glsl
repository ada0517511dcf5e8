// SPDX-License-Identifier: MIT
// summary: Where a sun ray's track leaves a texel or a block of texels, and which texel comes next.
// source:  Algo 2 and eq. 3 of Timokhin & Mikhaylyuk 2022 with errata c, g, l: docs/errata.md
// host:    none
// options: none
#ifndef GNOMON_RELIEF_TRANSIT_GLSL
#define GNOMON_RELIEF_TRANSIT_GLSL

// The machine error of single precision: a component of the direction up to this counts as 0.
#define GNOMON_TRANSIT_EPSILON 1.1920929e-7f

struct GnomonTransit {
  float t;       // from the entry to the exit, in lengths of the direction; -1 where the direction has none
  ivec2 offset;  // of the next texel or block: columns eastward, rows southward
};

// P_out = entry + direction * t of the block of side x side texels that begins at texel `low`. The block is left through
// the sides at the corner that the signs of the direction point to (erratum c: the signed component decides).
GnomonTransit gnomon_transit(vec2 entry, ivec2 low, int side, vec2 direction) {
  GnomonTransit transit;
  transit.t = -1.0f;
  transit.offset = ivec2(0, 0);
  bool along_x = abs(direction.x) > GNOMON_TRANSIT_EPSILON;
  bool along_y = abs(direction.y) > GNOMON_TRANSIT_EPSILON;
  ivec2 corner = low + ivec2(direction.x >= 0.0f ? side : 0, direction.y >= 0.0f ? side : 0);
  vec2 ahead = vec2(corner) - entry;
  ivec2 onward = ivec2(direction.x >= 0.0f ? 1 : -1, direction.y >= 0.0f ? 1 : -1);
  if (along_x && along_y) {
    vec2 exits = vec2(ahead.x / direction.x, ahead.y / direction.y);
    transit.t = min(exits.x, exits.y);
    if (exits.x <= exits.y) transit.offset.x = onward.x;
    if (exits.y <= exits.x) transit.offset.y = onward.y;
  } else if (along_y) {
    transit.t = abs(ahead.y) / abs(direction.y);
    transit.offset.y = onward.y;
  } else if (along_x) {
    transit.t = abs(ahead.x) / abs(direction.x);
    transit.offset.x = onward.x;
  }
  return transit;
}

// The texel that the track enters where it leaves that block at `exit_point`. The crossed axis steps by integer index;
// the other one follows by floor, held inside the block and never back behind `current`, the texel by which the track
// came in (erratum g: taken from the exit point alone, the walk can stand still for ever).
ivec2 gnomon_transit_next(GnomonTransit transit, vec2 exit_point, ivec2 current, ivec2 low, int side, vec2 direction) {
  ivec2 high = low + ivec2(side - 1, side - 1);
  ivec2 nearest = ivec2(direction.x >= 0.0f ? current.x : low.x, direction.y >= 0.0f ? current.y : low.y);
  ivec2 farthest = ivec2(direction.x >= 0.0f ? high.x : current.x, direction.y >= 0.0f ? high.y : current.y);
  ivec2 next = min(max(ivec2(floor(exit_point)), nearest), farthest);
  if (transit.offset.x != 0) next.x = transit.offset.x > 0 ? high.x + 1 : low.x - 1;
  if (transit.offset.y != 0) next.y = transit.offset.y > 0 ? high.y + 1 : low.y - 1;
  return next;
}

#endif
