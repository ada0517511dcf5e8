// SPDX-License-Identifier: MIT
// One level of block maxima, a pixel a block: the first from the heights, each further one from the level below.
#include <gnomon/host/r32f.glsl>
#include <gnomon/relief/extrema.glsl>

uniform int u_level;
layout(location = 0) out float o_highest;

void main() {
  ivec2 block = ivec2(gl_FragCoord.xy);
  o_highest = u_level == 1 ? gnomon_extrema_of_patches(block, 0) : gnomon_extrema_of_blocks(block, u_level, 0);
}
