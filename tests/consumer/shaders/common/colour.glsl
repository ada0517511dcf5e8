// SPDX-License-Identifier: MIT
vec4 consumer_colour(float brightness) { return vec4(brightness, brightness, BLUE * brightness, 1.0); }
