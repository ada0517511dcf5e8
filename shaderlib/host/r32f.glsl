// SPDX-License-Identifier: MIT
// summary: Host functions over R32F textures: one holds H_q, the mip levels of the other its block maxima.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_height, gnomon_host_extrema
// options: GNOMON_HEIGHTS (gnomon_heights): name of the height sampler; GNOMON_EXTREMA (gnomon_extrema): of the extrema
#ifndef GNOMON_HOST_R32F_GLSL
#define GNOMON_HOST_R32F_GLSL

#include <gnomon/host/extrema_r32f.glsl>

#ifndef GNOMON_HEIGHTS
#define GNOMON_HEIGHTS gnomon_heights
#endif

// R32F, metres: H_q for the one q that the draw asks for, a texel a sample.
uniform highp sampler2D GNOMON_HEIGHTS;

float gnomon_host_height(ivec2 sample_index, int q) {
  ivec2 last = textureSize(GNOMON_HEIGHTS, 0) - ivec2(1, 1);
  return texelFetch(GNOMON_HEIGHTS, clamp(sample_index, ivec2(0, 0), last), 0).r;
}

#endif
