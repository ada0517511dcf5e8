// SPDX-License-Identifier: MIT
// summary: What the host engine defines: where heights and their bounds come from.
// source:  docs/architecture.md, "Host contract"
// host:    gnomon_host_height, gnomon_host_extrema
// options: none
#ifndef GNOMON_CORE_HEIGHT_MAP_GLSL
#define GNOMON_CORE_HEIGHT_MAP_GLSL

// Height of the sample at (column, row) of H_q, clamped to the edge. Metres.
float gnomon_host_height(ivec2 sample_index, int q);

// Highest sample over a block of 2^level x 2^level patches of H_q, level >= 1: block (x, y) begins at patch
// (x * 2^level, y * 2^level). Metres.
float gnomon_host_extrema(ivec2 block, int level, int q);

#endif
