// SPDX-License-Identifier: MIT
// summary: The papers' own map of height extrema, H_ext. It bounds nothing: only relief/multilevel_literal asks for it.
// source:  Timokhin & Mikhaylyuk 2022, section 3 and figure 2; what is wrong with it: docs/errata.md, a and d
// host:    gnomon_host_height, gnomon_host_literal_extrema
// options: none
#ifndef GNOMON_RELIEF_LITERAL_EXTREMA_GLSL
#define GNOMON_RELIEF_LITERAL_EXTREMA_GLSL

#include <gnomon/core/height_map.glsl>
#include <gnomon/core/portable.glsl>

// h_max and h_min of H_ext for a block of 2^level x 2^level texels of H_0, level >= 1 (the papers count it from 0): block
// (x, y) begins at texel (x * 2^level, y * 2^level). Metres.
GNOMON_OPTIONAL vec2 gnomon_host_literal_extrema(ivec2 block, int level);

// The surface of H_0 at the corner that four texels share, of which `south_east` is one: what GL_LINEAR gives there.
float gnomon_corner_height(ivec2 south_east) {
  float north = gnomon_host_height(south_east - ivec2(1, 1), 0) + gnomon_host_height(south_east - ivec2(0, 1), 0);
  float south = gnomon_host_height(south_east - ivec2(1, 0), 0) + gnomon_host_height(south_east, 0);
  return (north + south) * 0.25f;
}

vec2 gnomon_wider_extrema(vec2 a, vec2 b) {
  return vec2(max(a.x, b.x), min(a.y, b.y));
}

// Level 1, the papers' 0th: highest and lowest of the surface at the 3 x 3 corners of 2 x 2 texels.
vec2 gnomon_literal_extrema_of_texels(ivec2 block) {
  ivec2 first = block * 2;
  float height = gnomon_corner_height(first);
  vec2 extrema = vec2(height, height);
  for (int i = 1; i < 9; ++i) {
    height = gnomon_corner_height(first + ivec2(i % 3, i / 3));
    extrema = gnomon_wider_extrema(extrema, vec2(height, height));
  }
  return extrema;
}

// Level `level` >= 2: of the four blocks one level below.
vec2 gnomon_literal_extrema_of_blocks(ivec2 block, int level) {
  ivec2 child = block * 2;
  vec2 north = gnomon_wider_extrema(gnomon_host_literal_extrema(child, level - 1),
                                    gnomon_host_literal_extrema(child + ivec2(1, 0), level - 1));
  vec2 south = gnomon_wider_extrema(gnomon_host_literal_extrema(child + ivec2(0, 1), level - 1),
                                    gnomon_host_literal_extrema(child + ivec2(1, 1), level - 1));
  return gnomon_wider_extrema(north, south);
}

#endif
