// SPDX-License-Identifier: MIT
#include "common/light.glsl"
#include <common/colour.glsl>

layout(location = 0) in vec3 v_normal;
out vec4 o_colour;

void main() { o_colour = consumer_colour(consumer_light(v_normal)); }
