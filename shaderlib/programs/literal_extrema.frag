// SPDX-License-Identifier: MIT
// One level of the papers' H_ext: the first from the heights of H_0, each further one from the level below.
#include <gnomon/host/r32f.glsl>
#include <gnomon/host/literal_extrema_rg32f.glsl>

uniform int u_level;
layout(location = 0) out vec2 extrema;

void main() {
  ivec2 block = ivec2(gl_FragCoord.xy);
  extrema = u_level == 1 ? gnomon_literal_extrema_of_texels(block) : gnomon_literal_extrema_of_blocks(block, u_level);
}
