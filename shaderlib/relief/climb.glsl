// SPDX-License-Identifier: MIT
// summary: How a walk over the pyramid gets to coarser blocks again.
// source:  docs/algorithms.md, "multilevel"
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_RELIEF_CLIMB_GLSL
#define GNOMON_RELIEF_CLIMB_GLSL

#include <gnomon/core/cursor.glsl>

// The level to go on with: one coarser where the parent block changed, which is much quicker than beginning again at the
// coarsest.
int gnomon_climb(ivec2 left, ivec2 entered, int level, int top_level) {
  ivec2 changed = (left >> (level + 1)) ^ (entered >> (level + 1));
  return (changed.x | changed.y) != 0 ? min(level + 1, top_level) : level;
}

#endif
