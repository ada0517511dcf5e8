// SPDX-License-Identifier: MIT
// summary: Host functions over 16-bit heights in an R16 or R16UI texture, with scale and offset; block maxima as R32F.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_height, gnomon_host_extrema
// options: GNOMON_HEIGHTS (gnomon_heights): name of the height sampler; GNOMON_EXTREMA (gnomon_extrema): of the extrema;
//          GNOMON_R16_INTEGER (off): R16UI and a usampler2D, as OpenGL ES and WebGL have R16 by extension only;
//          GNOMON_R16_SCALE (1.0): metres = stored * scale + offset, a literal or the name of a float;
//          GNOMON_R16_OFFSET (0.0): likewise, metres;
//          GNOMON_R16_NO_SAMPLE (off): stored number that says that there is no sample, 0..65535
#ifndef GNOMON_HOST_R16_GLSL
#define GNOMON_HOST_R16_GLSL

#include <gnomon/host/decode.glsl>
#include <gnomon/host/extrema_r32f.glsl>

#ifndef GNOMON_HEIGHTS
#define GNOMON_HEIGHTS gnomon_heights
#endif
#ifndef GNOMON_R16_SCALE
#define GNOMON_R16_SCALE 1.0
#endif
#ifndef GNOMON_R16_OFFSET
#define GNOMON_R16_OFFSET 0.0
#endif

// 0..65535, a texel a sample of H_q.
#ifdef GNOMON_R16_INTEGER
uniform highp usampler2D GNOMON_HEIGHTS;
#else
uniform highp sampler2D GNOMON_HEIGHTS;
#endif

float gnomon_host_height(ivec2 sample_index, int q) {
  ivec2 last = textureSize(GNOMON_HEIGHTS, 0) - ivec2(1, 1);
  ivec2 texel = clamp(sample_index, ivec2(0, 0), last);
#ifdef GNOMON_R16_INTEGER
  int stored = int(texelFetch(GNOMON_HEIGHTS, texel, 0).r);
#else
  int stored = gnomon_stored_number(texelFetch(GNOMON_HEIGHTS, texel, 0).r, 65535.0);
#endif
#ifdef GNOMON_R16_NO_SAMPLE
  if (stored == GNOMON_R16_NO_SAMPLE) return GNOMON_NO_SAMPLE;
#endif
  return gnomon_scaled_height(stored, GNOMON_R16_SCALE, GNOMON_R16_OFFSET);
}

#endif
