// SPDX-License-Identifier: MIT
// summary: The papers' H_ext in the mip levels of an RG32F texture, whatever holds the heights.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_literal_extrema
// options: GNOMON_LITERAL_EXTREMA (gnomon_literal_extrema): name of the sampler
#ifndef GNOMON_HOST_LITERAL_EXTREMA_RG32F_GLSL
#define GNOMON_HOST_LITERAL_EXTREMA_RG32F_GLSL

#include <gnomon/relief/literal_extrema.glsl>

#ifndef GNOMON_LITERAL_EXTREMA
#define GNOMON_LITERAL_EXTREMA gnomon_literal_extrema
#endif

// RG32F, metres, highest and lowest: mip level k holds blocks of level k + 1. Each side is a multiple of 2^(levels - 1).
uniform highp sampler2D GNOMON_LITERAL_EXTREMA;

vec2 gnomon_host_literal_extrema(ivec2 block, int level) {
  vec4 texel = texelFetch(GNOMON_LITERAL_EXTREMA, block, level - 1);
  return vec2(texel.r, texel.g);
}

#endif
