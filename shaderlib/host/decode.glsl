// SPDX-License-Identifier: MIT
// summary: Stored numbers to metres, for each encoding of heights the same bits on every GPU and in C++.
// source:  docs/architecture.md, "Host contract"
// host:    none
// options: none
#ifndef GNOMON_HOST_DECODE_GLSL
#define GNOMON_HOST_DECODE_GLSL

#include <gnomon/core/portable.glsl>

// The integer in 0..largest that a normalised texture channel holds; exact up to 16 bits.
int gnomon_stored_number(float channel, float largest) {
  return int(floor(channel * largest + 0.5f));
}

// R * 65536 + G * 256 + B of channels in 0..1.
int gnomon_stored_rgb(float red, float green, float blue) {
  return (gnomon_stored_number(red, 255.0f) << 16) + (gnomon_stored_number(green, 255.0f) << 8) +
         gnomon_stored_number(blue, 255.0f);
}

// stored * scale + offset, metres, for 16 bits. Only the sum rounds where `scale` has at most 8 significant bits, as any
// power of two; else the product rounds too, and where the dialect has no `precise` a GPU may fuse the two.
float gnomon_scaled_height(int stored, float scale, float offset) {
  GNOMON_PRECISE float product = float(stored) * scale;
  GNOMON_PRECISE float metres = product + offset;
  return metres;
}

// whole / 10 rounded once, from a quotient that is off by a few units in the last place, as GPUs divide. |whole| is an
// integer below 2^24. In integers, which no compiler reorders and no GPU rounds: quotient = mantissa * 2^-shift, and what
// is missing, whole * 2^shift - 10 * mantissa, tells by how many units it is off. There are no ties: both terms are even.
// A second pass, because units change where the first one crosses a power of two; from such a power down they are half
// as large.
float gnomon_exact_tenth(int whole, float quotient) {
  if (whole == 0) return 0.0f;
  int bits = floatBitsToInt(abs(quotient));
  for (int pass = 0; pass < 2; ++pass) {
    int mantissa = (bits & 0x7fffff) | 0x800000;
    int shift = 150 - (bits >> 23);
    int missing = (abs(whole) << shift) - 10 * mantissa;
    if (missing < 0 && mantissa == 0x800000) missing += missing;
    bits += missing >= 0 ? (missing + 5) / 10 : -((5 - missing) / 10);
  }
  float tenth = intBitsToFloat(bits);
  return whole < 0 ? -tenth : tenth;
}

// Mapbox Terrain-RGB: -10000 + stored * 0.1 metres, rounded once.
float gnomon_terrain_rgb_height(int stored) {
  int decimetres = stored - 100000;
  return gnomon_exact_tenth(decimetres, float(decimetres) / 10.0f);
}

// Terrarium: stored / 256 - 32768 metres, always exact.
float gnomon_terrarium_height(int stored) {
  return float(stored - 8388608) * 0.00390625f;
}

#endif
