// SPDX-License-Identifier: MIT
// summary: The colour of sunlit ground: albedo, Lambert's cosine law, and the shadow's factor.
// source:  Timokhin & Mikhaylyuk 2022, eq. 1 blended into the lit relief; Lambert 1760
// host:    gnomon_host_height
// options: none
#ifndef GNOMON_SHADING_LIT_GLSL
#define GNOMON_SHADING_LIT_GLSL

#include <gnomon/core/ray.glsl>
#include <gnomon/core/surface.glsl>

// Unit normal of the bilinear surface where the receiver stands: x east, y north, z up. Straight up where there is none.
vec3 gnomon_surface_normal(GnomonMap map, GnomonReceiver receiver, int q) {
  GnomonReceiver here = gnomon_on_surface(receiver, q);
  GnomonPatch p = gnomon_patch(here.patch_index, gnomon_host_height(here.patch_index, q), q);
  if (p.hole) return vec3(0.0f, 0.0f, 1.0f);
  float east = (p.slope.x + p.twist * here.fraction.y) / map.spacing.x;
  float south = (p.slope.y + p.twist * here.fraction.x) / map.spacing.y;
  return normalize(vec3(-east, south, 1.0f));
}

// Linear colour of ground with this albedo (0..1 a component). `ambient`: share of the light that comes from
// everywhere, 0..1; the rest is the sun's. k_shadow darkens both.
vec3 gnomon_lit(vec3 albedo, vec3 normal, vec3 to_sun, float k_shadow, float ambient) {
  float direct = max(dot(normal, to_sun), 0.0f);
  return albedo * ((ambient + (1.0f - ambient) * direct) * k_shadow);
}

#endif
