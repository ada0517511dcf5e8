// SPDX-License-Identifier: MIT
// H_{q+1} from H_q: a pixel a sample.
#include <gnomon/host/r32f.glsl>
#include <gnomon/relief/extrema.glsl>

layout(location = 0) out float coarser_height;

void main() {
  coarser_height = gnomon_coarser_height(ivec2(gl_FragCoord.xy), textureSize(GNOMON_HEIGHTS, 0), 0);
}
