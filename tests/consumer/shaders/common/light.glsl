// SPDX-License-Identifier: MIT
#ifndef CONSUMER_LIGHT
#define CONSUMER_LIGHT
#include <gnomon/relief/shade.glsl>

uniform vec3 u_to_sun;

float consumer_light(vec3 normal) {
  float shadow = dot(normal, u_to_sun) < 0.0 ? 1.0 : 0.0;
  return gnomon_k_shadow(shadow, u_to_sun.z, 0.2, 0.6);
}
#endif
