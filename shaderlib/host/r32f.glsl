// SPDX-License-Identifier: MIT
// summary: Host functions over R32F textures: one holds H_q, the mip levels of the other its block maxima.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_height, gnomon_host_extrema
// options: GNOMON_HEIGHTS (gnomon_heights): name of the height sampler; GNOMON_EXTREMA (gnomon_extrema): of the extrema
#ifndef GNOMON_HOST_R32F_GLSL
#define GNOMON_HOST_R32F_GLSL

#include <gnomon/core/height_map.glsl>

#ifndef GNOMON_HEIGHTS
#define GNOMON_HEIGHTS gnomon_heights
#endif
#ifndef GNOMON_EXTREMA
#define GNOMON_EXTREMA gnomon_extrema
#endif

// R32F, metres: H_q for the one q that the draw asks for, a texel a sample.
uniform highp sampler2D GNOMON_HEIGHTS;
// R32F, metres: mip level k holds blocks of level k + 1. Each side is a multiple of 2^(levels - 1), so that GL's own
// halving is exact and no block is lost.
uniform highp sampler2D GNOMON_EXTREMA;

float gnomon_host_height(ivec2 sample_index, int q) {
  ivec2 last = textureSize(GNOMON_HEIGHTS, 0) - ivec2(1, 1);
  return texelFetch(GNOMON_HEIGHTS, clamp(sample_index, ivec2(0, 0), last), 0).r;
}

float gnomon_host_extrema(ivec2 block, int level, int q) {
  return texelFetch(GNOMON_EXTREMA, block, level - 1).r;
}

#endif
