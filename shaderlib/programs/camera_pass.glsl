// SPDX-License-Identifier: MIT
// A perspective or orthographic camera, the viewer's or the sun's.
#ifndef GNOMON_PROGRAMS_CAMERA_PASS_GLSL
#define GNOMON_PROGRAMS_CAMERA_PASS_GLSL

#include "map_pass.glsl"

uniform vec3 u_eye;        // metres; of the image's middle for parallel rays
uniform vec3 u_forward;    // unit vector
uniform vec3 u_right;      // from a pixel to its right neighbour: in lengths of u_forward (perspective) or metres
uniform vec3 u_down;       // from a pixel to the one below, likewise
uniform vec2 u_middle;     // of the image, pixels
uniform int u_perspective;

#endif
