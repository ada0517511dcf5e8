// SPDX-License-Identifier: MIT
// summary: How dark a shadow is: k_shadow, the factor of the lit colour.
// source:  eq. 1 of Timokhin & Mikhaylyuk 2022, with max(s.n, 0): docs/algorithms.md, "Conventions"
// host:    none
// options: none
#ifndef GNOMON_RELIEF_SHADE_GLSL
#define GNOMON_RELIEF_SHADE_GLSL

// (k_dark + (k_bright - k_dark) * max(sun_height, 0)) ^ shadow. shadow: b_shadow, 0..1; sun_height: s.n, the sine of
// the sun's elevation; k_dark, k_bright in 0..1: the factor with the sun at the horizon and at the zenith. 1 where lit.
float gnomon_k_shadow(float shadow, float sun_height, float k_dark, float k_bright) {
  float k = k_dark + (k_bright - k_dark) * max(sun_height, 0.0f);
  // A hard shadow takes the factor itself: pow() is not exact, and pow(0, 0) is undefined.
  if (shadow >= 1.0f) return k;
  if (shadow <= 0.0f) return 1.0f;
  return pow(k, shadow);
}

#endif
