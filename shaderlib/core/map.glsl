// SPDX-License-Identifier: MIT
// summary: The height map and the receiver of a shadow, as every shadow method takes them.
// source:  docs/algorithms.md, "Conventions"
// host:    none
// options: none
#ifndef GNOMON_CORE_MAP_GLSL
#define GNOMON_CORE_MAP_GLSL

#include <gnomon/core/portable.glsl>

// Level q of a height map. Sample (column, row) lies at column + 0.5, row + 0.5 in texels of this level; the surface is
// bilinear between the samples and ends at `domain`. A patch is the square between four neighbouring samples: patch
// (x, y) lies between the samples (x - 1, y - 1) and (x, y), so there are (width + 1) x (height + 1) of them.
struct GnomonMap {
  ivec2 size;       // samples from west to east, from north to south
  vec2 domain;      // extent in texels of this level; `size` at level 0, size of the base map / 2^q at level q
  vec2 spacing;     // metres a texel, east-west and north-south
  float highest;    // highest sample of this level, metres
  int top_level;    // coarsest level of gnomon_host_extrema, >= 1
};

// Where a shadow is asked.
struct GnomonReceiver {
  ivec2 patch_index;  // the patch it stands in
  vec2 fraction;      // position in that patch, 0..1, eastward and southward
  float height;       // metres above the surface of the level, >= 0; 0 is exactly on it
};

// The patch index and fraction of one coordinate in texels. Exact: no sum here rounds but for a coordinate below 0.5.
int gnomon_patch_of(float coordinate, GNOMON_OUT(float) fraction) {
  float whole = floor(coordinate);
  float rest = coordinate - whole;
  bool second_half = rest >= 0.5f;
  fraction = second_half ? rest - 0.5f : rest + 0.5f;
  return int(whole) + (second_half ? 1 : 0);
}

// The receiver at (column, row) in texels of the level, `height` metres above the surface.
GnomonReceiver gnomon_receiver_at(float column, float row, float height) {
  GnomonReceiver receiver;
  float fraction_x = 0.0f;
  float fraction_y = 0.0f;
  int patch_x = gnomon_patch_of(column, fraction_x);
  int patch_y = gnomon_patch_of(row, fraction_y);
  receiver.patch_index = ivec2(patch_x, patch_y);
  receiver.fraction = vec2(fraction_x, fraction_y);
  receiver.height = height;
  return receiver;
}

#endif
