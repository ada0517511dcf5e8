// SPDX-License-Identifier: MIT
#include <gnomon/host/r32f.glsl>
#include <gnomon/host/light_nearness.glsl>
#include <gnomon/baseline/cascaded_shadow_maps.glsl>
#include "light_pass.glsl"
#include "shadow_pass.glsl"

void main() {
  write_shadow(gnomon_cascaded_shadow_maps(pass_map(), pass_receiver(), u_to_sun, u_q, pass_light()));
}
