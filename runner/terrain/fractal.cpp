// SPDX-License-Identifier: MIT
// Mountains: ridged fractional Brownian motion.
#include <algorithm>
#include <cmath>

#include "terrain/generator.h"
#include "terrain/noise.h"

namespace gnomon::terrain {

Heights fractal(const Grid& grid, const Parameters& parameters) {
  const double gain = parameters.at("gain");
  const double lacunarity = parameters.at("lacunarity");
  const int octaves = static_cast<int>(parameters.at("octaves"));

  Heights heights(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), 0.0);
  Octave octave{.cell = grid.width_metres() / parameters.at("cells"), .seed = hash(grid.seed)};
  double amplitude = 1.0;
  for (int k = 0; k < octaves; ++k) {
    const Heights noise = sample_noise(grid, octave);
    for (std::size_t i = 0; i < heights.size(); ++i) {
      const double ridge = 1.0 - std::abs(noise[i]);
      heights[i] += amplitude * (ridge * ridge);
    }
    amplitude *= gain;
    octave.cell /= lacunarity;
    octave.seed = hash(octave.seed);
  }

  // The relief is the definition: the lowest sample is 0, the highest exactly `relief`.
  const auto [lowest, highest] = std::minmax_element(heights.begin(), heights.end());
  const double base = *lowest;
  const double range = *highest - base;
  for (double& height : heights)
    height = range > 0.0 ? (height - base) / range * parameters.at("relief") : 0.0;
  return heights;
}

}  // namespace gnomon::terrain
