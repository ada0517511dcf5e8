// SPDX-License-Identifier: MIT
// Methods side by side on the same work, in one run: what a claim of speed rests on.
#pragma once

#include <string>
#include <vector>

#include "engine.h"
#include "gnomon/diagnostic.h"

namespace gnomon {

struct BenchOptions {
  int size = 1024;        ///< samples a side of the fractal map; a pixel a sample
  double azimuth = 315;   ///< degrees
  double elevation = 10;  ///< degrees
  int rounds = 5;         ///< how often each method runs, in turn: A B A B ...
};

/// One method's figures. Times are wall-clock seconds of the draws alone: the pyramid is built before and
/// timed apart.
struct BenchFigure {
  std::string method;
  std::vector<double> seconds;  ///< one a round
  double median = 0;
  double mean_steps = 0;  ///< patches and blocks a ray
  double mismatches = 0;  ///< rays that differ from the oracle outside the band
  double in_band = 0;
};

struct BenchResult {
  BenchOptions options;
  double pyramid_seconds = 0;
  double rays = 0;  ///< a round
  std::vector<BenchFigure> figures;
};

[[nodiscard]] Result<BenchResult> bench(Engine& engine, const BenchOptions& options);

}  // namespace gnomon
