// SPDX-License-Identifier: MIT
// summary: Host functions over linear memory: a storage buffer, a texture buffer or a texture, by what the dialect has.
// source:  docs/architecture.md, "Host contract"
// host:    defines gnomon_host_height, gnomon_host_extrema
// options: GNOMON_BUFFER_KIND (GNOMON_BUFFER_BY_DIALECT): the first of the following that the dialect has, or one of them:
//          GNOMON_BUFFER_STORAGE, GNOMON_BUFFER_TEXTURE (a samplerBuffer), GNOMON_BUFFER_LINEAR (a sampler2D whose rows
//          follow each other);
//          GNOMON_HEIGHTS (gnomon_heights): name of the heights' block or sampler;
//          GNOMON_EXTREMA (gnomon_extrema): of the extrema's;
//          GNOMON_HEIGHTS_BINDING (0): of the storage block;
//          GNOMON_EXTREMA_BINDING (1): likewise;
//          GNOMON_HEIGHTS_SIZE (gnomon_heights_size): an ivec2 of your own instead of a uniform of this file;
//          GNOMON_EXTREMA_SIZE (gnomon_extrema_size): likewise
#ifndef GNOMON_HOST_BUFFER_GLSL
#define GNOMON_HOST_BUFFER_GLSL

#include <gnomon/core/height_map.glsl>
#include <gnomon/core/portable.glsl>

#define GNOMON_BUFFER_BY_DIALECT 0
#define GNOMON_BUFFER_STORAGE 1
#define GNOMON_BUFFER_TEXTURE 2
#define GNOMON_BUFFER_LINEAR 3
#ifndef GNOMON_BUFFER_KIND
#define GNOMON_BUFFER_KIND GNOMON_BUFFER_BY_DIALECT
#endif
#if GNOMON_BUFFER_KIND != GNOMON_BUFFER_BY_DIALECT
#define GNOMON_BUFFER_CHOSEN GNOMON_BUFFER_KIND
#elif GNOMON_HAS_STORAGE_BUFFER
#define GNOMON_BUFFER_CHOSEN GNOMON_BUFFER_STORAGE
#elif GNOMON_HAS_TEXTURE_BUFFER
#define GNOMON_BUFFER_CHOSEN GNOMON_BUFFER_TEXTURE
#else
#define GNOMON_BUFFER_CHOSEN GNOMON_BUFFER_LINEAR
#endif

#ifndef GNOMON_HEIGHTS
#define GNOMON_HEIGHTS gnomon_heights
#endif
#ifndef GNOMON_EXTREMA
#define GNOMON_EXTREMA gnomon_extrema
#endif
#ifndef GNOMON_HEIGHTS_BINDING
#define GNOMON_HEIGHTS_BINDING 0
#endif
#ifndef GNOMON_EXTREMA_BINDING
#define GNOMON_EXTREMA_BINDING 1
#endif

// Samples of H_q, east-west and north-south.
#ifndef GNOMON_HEIGHTS_SIZE
#define GNOMON_HEIGHTS_SIZE gnomon_heights_size
uniform highp ivec2 gnomon_heights_size;
#endif
// Blocks of level 1; each side a multiple of 2^(levels - 1), so that every further level has half the sides exactly.
#ifndef GNOMON_EXTREMA_SIZE
#define GNOMON_EXTREMA_SIZE gnomon_extrema_size
uniform highp ivec2 gnomon_extrema_size;
#endif

// float32, metres. Heights row by row, the northern first; extrema likewise, one level after the other from level 1.
#if GNOMON_BUFFER_CHOSEN == GNOMON_BUFFER_STORAGE
layout(std430, binding = GNOMON_HEIGHTS_BINDING) readonly buffer GNOMON_HEIGHTS {
  highp float metres[];
} gnomon_height_block;
layout(std430, binding = GNOMON_EXTREMA_BINDING) readonly buffer GNOMON_EXTREMA {
  highp float metres[];
} gnomon_extrema_block;
#elif GNOMON_BUFFER_CHOSEN == GNOMON_BUFFER_TEXTURE
uniform highp samplerBuffer GNOMON_HEIGHTS;
uniform highp samplerBuffer GNOMON_EXTREMA;
#else
uniform highp sampler2D GNOMON_HEIGHTS;
uniform highp sampler2D GNOMON_EXTREMA;

ivec2 gnomon_linear_texel(int index, int width) {
  int row = index / width;
  return ivec2(index - row * width, row);
}
#endif

float gnomon_host_height(ivec2 sample_index, int q) {
  ivec2 size = GNOMON_HEIGHTS_SIZE;
  ivec2 inside = clamp(sample_index, ivec2(0, 0), size - ivec2(1, 1));
  int index = inside.y * size.x + inside.x;
#if GNOMON_BUFFER_CHOSEN == GNOMON_BUFFER_STORAGE
  return gnomon_height_block.metres[index];
#elif GNOMON_BUFFER_CHOSEN == GNOMON_BUFFER_TEXTURE
  return texelFetch(GNOMON_HEIGHTS, index).r;
#else
  return texelFetch(GNOMON_HEIGHTS, gnomon_linear_texel(index, textureSize(GNOMON_HEIGHTS, 0).x), 0).r;
#endif
}

float gnomon_host_extrema(ivec2 block, int level, int q) {
  ivec2 size = GNOMON_EXTREMA_SIZE;
  int finest = size.x * size.y;
  // The sum finest + finest / 4 + finest / 16 + ... over the levels before this one.
  int begin = (finest - (finest >> (2 * (level - 1)))) / 3 * 4;
  int index = begin + block.y * (size.x >> (level - 1)) + block.x;
#if GNOMON_BUFFER_CHOSEN == GNOMON_BUFFER_STORAGE
  return gnomon_extrema_block.metres[index];
#elif GNOMON_BUFFER_CHOSEN == GNOMON_BUFFER_TEXTURE
  return texelFetch(GNOMON_EXTREMA, index).r;
#else
  return texelFetch(GNOMON_EXTREMA, gnomon_linear_texel(index, textureSize(GNOMON_EXTREMA, 0).x), 0).r;
#endif
}

#endif
