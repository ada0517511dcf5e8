// SPDX-License-Identifier: MIT
// The depth of a mesh with holes as the sun sees it: what has no surface is left out.
#include <gnomon/host/r32f.glsl>
#include "mesh_pass.glsl"

void main() {
  if (mesh_has_hole(mesh_at())) discard;
}
