// SPDX-License-Identifier: MIT
#include <gnomon/host/r32f.glsl>
#include "extrema_pass.glsl"

void main() {
  write_extrema();
}
