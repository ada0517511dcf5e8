// SPDX-License-Identifier: MIT
// summary: Whether a map with holes has a surface under a receiver.
// source:  docs/algorithms.md, "Holes"
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_CORE_SURFACE_GLSL
#define GNOMON_CORE_SURFACE_GLSL

#include <gnomon/core/height_map.glsl>
#include <gnomon/core/map.glsl>

// A patch with a corner that is no sample has no surface.
bool gnomon_patch_has_surface(ivec2 patch_index, int q) {
  float north = min(gnomon_host_height(patch_index - ivec2(1, 1), q), gnomon_host_height(patch_index - ivec2(0, 1), q));
  float south = min(gnomon_host_height(patch_index - ivec2(1, 0), q), gnomon_host_height(patch_index, q));
  return gnomon_is_sample(min(north, south));
}

// The receiver as one of a patch with a surface: of its own, or of one beyond the edge or corner that it stands on. As it
// is where none of them has one.
GnomonReceiver gnomon_on_surface(GnomonReceiver receiver, int q) {
  ivec2 beside = ivec2(receiver.fraction.x <= 0.0f ? -1 : (receiver.fraction.x >= 1.0f ? 1 : 0),
                       receiver.fraction.y <= 0.0f ? -1 : (receiver.fraction.y >= 1.0f ? 1 : 0));
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2((i & 1) * beside.x, (i >> 1) * beside.y);
    if (gnomon_patch_has_surface(receiver.patch_index + step, q)) {
      GnomonReceiver moved = receiver;
      moved.patch_index = receiver.patch_index + step;
      moved.fraction = receiver.fraction - vec2(step);  // from one end of the edge's 0..1 to the other
      return moved;
    }
  }
  return receiver;
}

// Patches are closed: a receiver on an edge or a corner has a surface if one of the patches there has. Shadow methods
// answer for receivers that have one; what they say of others has no meaning.
bool gnomon_has_surface(GnomonReceiver receiver, int q) {
  return gnomon_patch_has_surface(gnomon_on_surface(receiver, q).patch_index, q);
}

#endif
