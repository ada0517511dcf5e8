// SPDX-License-Identifier: MIT
#include <gnomon/host/r32f.glsl>
#include <gnomon/host/literal_extrema_rg32f.glsl>
#include <gnomon/relief/multilevel_literal.glsl>
#include "shadow_pass.glsl"

void main() {
  write_shadow(gnomon_multilevel_literal(pass_map(), pass_receiver(), u_to_sun, u_q, u_step_limit));
}
