// SPDX-License-Identifier: MIT
// summary: Block maxima in the mip levels of an R32F texture, whatever holds the heights.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_extrema
// options: GNOMON_EXTREMA (gnomon_extrema): name of the sampler
#ifndef GNOMON_HOST_EXTREMA_R32F_GLSL
#define GNOMON_HOST_EXTREMA_R32F_GLSL

#include <gnomon/core/height_map.glsl>

#ifndef GNOMON_EXTREMA
#define GNOMON_EXTREMA gnomon_extrema
#endif

// R32F, metres: mip level k holds blocks of level k + 1. Each side is a multiple of 2^(levels - 1), so that GL's own
// halving is exact and no block is lost.
uniform highp sampler2D GNOMON_EXTREMA;

float gnomon_host_extrema(ivec2 block, int level, int q) {
  return texelFetch(GNOMON_EXTREMA, block, level - 1).r;
}

#endif
