// SPDX-License-Identifier: MIT
#include <gnomon/host/r32f.glsl>
#include <gnomon/relief/multilevel.glsl>
#include "shadow_pass.glsl"

void main() {
  write_shadow(gnomon_multilevel(pass_map(), pass_receiver(), u_to_sun, u_q, u_step_limit));
}
