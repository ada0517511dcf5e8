// SPDX-License-Identifier: MIT
// summary: Cascades side by side in one depth texture whose nearest value is 1.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_light_nearness
// options: GNOMON_LIGHT_NEARNESS (gnomon_light_nearness): name of the sampler
#ifndef GNOMON_HOST_LIGHT_NEARNESS_GLSL
#define GNOMON_HOST_LIGHT_NEARNESS_GLSL

#include <gnomon/core/portable.glsl>

#ifndef GNOMON_LIGHT_NEARNESS
#define GNOMON_LIGHT_NEARNESS gnomon_light_nearness
#endif

// Depth, of two cascades side by side and two rows of them where there are more than one: cascade i at column i & 1, row
// i >> 1.
uniform highp sampler2D GNOMON_LIGHT_NEARNESS;
uniform int u_light_size;  // texels a side of a cascade

float gnomon_host_light_nearness(ivec2 texel, int cascade) {
  ivec2 first = ivec2(cascade & 1, cascade >> 1) * u_light_size;
  return texelFetch(GNOMON_LIGHT_NEARNESS, first + texel, 0).r;
}

#endif
