// SPDX-License-Identifier: MIT
// summary: Levels of detail H_q and the maxima over blocks of patches that bound each of them.
// source:  docs/algorithms.md, "Conventions" and "multilevel"; H_ext of Timokhin & Mikhaylyuk 2022 with errata a, d
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_RELIEF_EXTREMA_GLSL
#define GNOMON_RELIEF_EXTREMA_GLSL

#include <gnomon/core/height_map.glsl>

// Sample (column, row) of H_{q+1}: the mean of its children in H_q, which is `size` samples large. A child that is
// absent, beyond the east or south edge or no sample, counts 0 and is left out of the divisor; without a child there is no
// sample. Every sum in a fixed order, so that GPU and C++ agree to the bit.
float gnomon_coarser_height(ivec2 sample_index, ivec2 size, int q) {
  ivec2 child = sample_index * 2;
  bool east = child.x + 1 < size.x;
  bool south = child.y + 1 < size.y;
  float north_west = gnomon_host_height(child, q);
  float north_east = east ? gnomon_host_height(child + ivec2(1, 0), q) : GNOMON_NO_SAMPLE;
  float south_west = south ? gnomon_host_height(child + ivec2(0, 1), q) : GNOMON_NO_SAMPLE;
  float south_east = east && south ? gnomon_host_height(child + ivec2(1, 1), q) : GNOMON_NO_SAMPLE;
  int children = (gnomon_is_sample(north_west) ? 1 : 0) + (gnomon_is_sample(north_east) ? 1 : 0) +
                 (gnomon_is_sample(south_west) ? 1 : 0) + (gnomon_is_sample(south_east) ? 1 : 0);
  if (children == 0) return GNOMON_NO_SAMPLE;
  float north_sum =
      (gnomon_is_sample(north_west) ? north_west : 0.0f) + (gnomon_is_sample(north_east) ? north_east : 0.0f);
  float south_sum =
      (gnomon_is_sample(south_west) ? south_west : 0.0f) + (gnomon_is_sample(south_east) ? south_east : 0.0f);
  // 1 / children, as a division is not exact on every GPU.
  float share = children == 4 ? 0.25f : (children == 3 ? 0.333333343f : (children == 2 ? 0.5f : 1.0f));
  return (north_sum + south_sum) * share;
}

// Level 1: the highest of the 3 x 3 samples at the corners of 2 x 2 patches, which bounds their bilinear surface.
// GNOMON_NO_SAMPLE lies below every height, so that it never counts where there is one.
float gnomon_extrema_of_patches(ivec2 block, int q) {
  ivec2 first = block * 2 - ivec2(1, 1);
  float highest = gnomon_host_height(first, q);
  for (int i = 1; i < 9; ++i) {
    highest = max(highest, gnomon_host_height(first + ivec2(i % 3, i / 3), q));
  }
  return highest;
}

// Level `level` >= 2: the highest of the four blocks one level below.
float gnomon_extrema_of_blocks(ivec2 block, int level, int q) {
  ivec2 child = block * 2;
  float north = max(gnomon_host_extrema(child, level - 1, q), gnomon_host_extrema(child + ivec2(1, 0), level - 1, q));
  float south =
      max(gnomon_host_extrema(child + ivec2(0, 1), level - 1, q), gnomon_host_extrema(child + ivec2(1, 1), level - 1, q));
  return max(north, south);
}

#endif
