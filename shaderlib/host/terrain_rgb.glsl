// SPDX-License-Identifier: MIT
// summary: Host functions over web map tiles, Mapbox Terrain-RGB or Terrarium, in an RGBA8 texture; block maxima as R32F.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_height, gnomon_host_extrema
// options: GNOMON_HEIGHTS (gnomon_heights): name of the height sampler; GNOMON_EXTREMA (gnomon_extrema): of the extrema;
//          GNOMON_TERRARIUM (off): Terrarium's encoding instead of Mapbox's
#ifndef GNOMON_HOST_TERRAIN_RGB_GLSL
#define GNOMON_HOST_TERRAIN_RGB_GLSL

#include <gnomon/host/decode.glsl>
#include <gnomon/host/extrema_r32f.glsl>

#ifndef GNOMON_HEIGHTS
#define GNOMON_HEIGHTS gnomon_heights
#endif

// RGBA8 or RGB8, a texel a sample of H_q. Not sRGB: that would bend the numbers.
uniform highp sampler2D GNOMON_HEIGHTS;

float gnomon_host_height(ivec2 sample_index, int q) {
  ivec2 last = textureSize(GNOMON_HEIGHTS, 0) - ivec2(1, 1);
  vec4 texel = texelFetch(GNOMON_HEIGHTS, clamp(sample_index, ivec2(0, 0), last), 0);
  int stored = gnomon_stored_rgb(texel.r, texel.g, texel.b);
#ifdef GNOMON_TERRARIUM
  return gnomon_terrarium_height(stored);
#else
  return gnomon_terrain_rgb_height(stored);
#endif
}

#endif
