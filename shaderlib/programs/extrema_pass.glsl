// SPDX-License-Identifier: MIT
// One level of block maxima: the first from the heights, each further one from the level below.
#ifndef GNOMON_PROGRAMS_EXTREMA_PASS_GLSL
#define GNOMON_PROGRAMS_EXTREMA_PASS_GLSL

#include <gnomon/relief/extrema.glsl>

uniform int u_level;
layout(location = 0) out float highest;

void write_extrema() {
  ivec2 block = ivec2(gl_FragCoord.xy);
  highest = u_level == 1 ? gnomon_extrema_of_patches(block, 0) : gnomon_extrema_of_blocks(block, u_level, 0);
}

#endif
