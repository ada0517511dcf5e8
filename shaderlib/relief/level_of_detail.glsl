// SPDX-License-Identifier: MIT
// summary: The coarsest level of detail that a pixel cannot tell from the map itself.
// source:  Algo 1 of Timokhin & Mikhaylyuk 2022; docs/algorithms.md, "Level of detail by pixel"
// host:    none
// options: none
#ifndef GNOMON_RELIEF_LEVEL_OF_DETAIL_GLSL
#define GNOMON_RELIEF_LEVEL_OF_DETAIL_GLSL

// Ratios that are exact (a view at twice the height, one texel a pixel) lie on a rounding's edge, where single precision
// decides by noise: both roundings are held back by this much, so that neighbouring pixels agree.
#define GNOMON_LEVEL_TOLERANCE 1e-4f

// n_a: how many samples along the pixel's longer side make up for a shorter one, 1..largest. Squared lengths, in texels.
float gnomon_anisotropy(float longer, float shorter, float largest) {
  if (shorter <= 0.0f) return largest;
  float ratio = sqrt(longer / shorter) - GNOMON_LEVEL_TOLERANCE;
  return ratio < largest ? ceil(ratio) : largest;
}

// q, 0..coarsest. along_x, along_y: how far the place on the map moves from a pixel to the next one in x and in y, in
// texels of H_0 per pixel (s_x, t_x and s_y, t_y of the paper). They are the caller's, from its camera: a shader's own
// dFdx is a difference between two pixels and would make neighbours differ. largest_anisotropy: n_a,max, 16 in the paper.
int gnomon_level_of_detail(vec2 along_x, vec2 along_y, float largest_anisotropy, int coarsest) {
  float a = along_x.x * along_x.x + along_x.y * along_x.y;
  float b = along_y.x * along_y.x + along_y.y * along_y.y;
  float longer = max(a, b);
  if (longer <= 0.0f) return 0;
  float n_a = gnomon_anisotropy(longer, min(a, b), largest_anisotropy);
  float q = floor(0.5f * log2(longer) - log2(n_a) + GNOMON_LEVEL_TOLERANCE);
  return int(min(max(q, 0.0f), float(coarsest)));
}

#endif
