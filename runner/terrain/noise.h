// SPDX-License-Identifier: MIT
// Seeded noise that is the same to the bit on every machine: integer hash, and + - * / sqrt in double (IEEE
// 754 rounds each of these correctly; no other function of the maths library is used).
#pragma once

#include <cstdint>

#include "terrain/generator.h"

namespace gnomon::terrain {

/// The PCG output permutation on one 32-bit word (Jarzynski & Olano, "Hash Functions for GPU Rendering", JCGT
/// 2020).
[[nodiscard]] constexpr std::uint32_t hash(std::uint32_t value) {
  const std::uint32_t state = value * 747796405u + 2891336453u;
  const std::uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

/// A hash of a seed and two integers, such as a lattice point.
[[nodiscard]] constexpr std::uint32_t hash(std::uint32_t seed, std::int64_t x, std::int64_t y) {
  return hash(hash(hash(seed) ^ static_cast<std::uint32_t>(x)) ^ static_cast<std::uint32_t>(y));
}

/// A hash as a number in [0, 1).
[[nodiscard]] constexpr double unit(std::uint32_t hashed) {
  return hashed / 4294967296.0;
}

/// One octave of gradient noise (Perlin 2002: quintic fade), scaled so that it reaches up to -1 and 1; 0 on
/// the lattice.
struct Octave {
  double cell = 1.0;  ///< metres between lattice points, on both axes
  std::uint32_t seed = 0;
};

/// Its value at every sample of the grid, row-major. The lattice starts at the north-west corner of the
/// domain.
[[nodiscard]] Heights sample_noise(const Grid& grid, const Octave& octave);

}  // namespace gnomon::terrain
