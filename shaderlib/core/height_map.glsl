// SPDX-License-Identifier: MIT
// summary: What the host engine defines: where heights and their bounds come from.
// source:  docs/architecture.md, "Host contract"
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_CORE_HEIGHT_MAP_GLSL
#define GNOMON_CORE_HEIGHT_MAP_GLSL

// What a host returns for a sample that holds no data, and what a block of maxima holds that has no other sample. Far
// below any height, so that a comparison tells it; small enough for differences of two to stay finite.
#define GNOMON_NO_SAMPLE -1e30f
// Every height of a map lies above this.
#define GNOMON_LOWEST_HEIGHT -1e20f

bool gnomon_is_sample(float height) {
  return height > GNOMON_LOWEST_HEIGHT;
}

// Height of the sample at (column, row) of H_q, clamped to the edge. Metres, or GNOMON_NO_SAMPLE.
float gnomon_host_height(ivec2 sample_index, int q);

// Highest sample over a block of 2^level x 2^level patches of H_q, level >= 1: block (x, y) begins at patch
// (x * 2^level, y * 2^level). Metres, or GNOMON_NO_SAMPLE where it has no sample.
float gnomon_host_extrema(ivec2 block, int level, int q);

#endif
