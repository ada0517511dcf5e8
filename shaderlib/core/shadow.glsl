// SPDX-License-Identifier: MIT
// summary: The answer of every hard-shadow method, and the suns that need no ray.
// source:  docs/algorithms.md, "Conventions"
// host:    none
// options: none
#ifndef GNOMON_CORE_SHADOW_GLSL
#define GNOMON_CORE_SHADOW_GLSL

// Why a method answered what it answered. A ray that reaches its step limit stays undecided: that is an error to report,
// never a lit pixel.
#define GNOMON_CAUSE_UNDECIDED 0
#define GNOMON_CAUSE_SURFACE 1          // shadow: the surface rises above the ray
#define GNOMON_CAUSE_SUN_BELOW 2        // shadow: the sun does not stand above the horizontal plane
#define GNOMON_CAUSE_ZENITH 3           // lit: nothing can stand between
#define GNOMON_CAUSE_LEFT_MAP 4         // lit: the ray left the domain
#define GNOMON_CAUSE_ABOVE_ALL 5        // lit: the ray rose above the highest sample
#define GNOMON_CAUSE_BELOW_BLOCK 6      // shadow: a block's lowest height rises to the ray; relief/multilevel_literal only

struct GnomonShadow {
  float shadow;  // b_shadow: 1 in shadow, 0 lit
  int steps;     // blocks and patches that the ray visited
  int cause;     // GNOMON_CAUSE_...
};

GnomonShadow gnomon_shadow(float shadow, int steps, int cause) {
  GnomonShadow result;
  result.shadow = shadow;
  result.steps = steps;
  result.cause = cause;
  return result;
}

// The answer for a sun at or under the horizontal plane and for one at the zenith; undecided for any other.
GnomonShadow gnomon_shadow_without_ray(vec3 to_sun) {
  if (to_sun.z <= 0.0f) return gnomon_shadow(1.0f, 0, GNOMON_CAUSE_SUN_BELOW);
  if (to_sun.x == 0.0f && to_sun.y == 0.0f) return gnomon_shadow(0.0f, 0, GNOMON_CAUSE_ZENITH);
  return gnomon_shadow(0.0f, 0, GNOMON_CAUSE_UNDECIDED);
}

#endif
