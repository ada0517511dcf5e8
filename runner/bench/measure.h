// SPDX-License-Identifier: MIT
// Images of the same map timed side by side in one run: what a claim of speed rests on.
#pragma once

#include <atomic>
#include <optional>
#include <string>
#include <vector>

#include "engine.h"
#include "gnomon/diagnostic.h"
#include "scene/scene.h"

namespace gnomon::bench {

/// One image. `map` is what reports call its terrain.
struct Trial {
  std::string map;
  scene::Scene scene;
};

/// Trials over one map, seen by one camera. The first is what the others' pixels are compared with.
struct Group {
  std::vector<Trial> trials;
  bool judged = true;  ///< whether the oracle is asked too
};

/// Times are wall-clock seconds of the draws alone, one a round; maps of the sun are drawn with each image, a
/// pyramid once and apart.
struct Figure {
  std::vector<double> seconds{};  ///< of the shadow
  double median = 0;
  double view_median = 0;              ///< of finding what the camera sees, 0 for the map camera
  double pixels = 0;                   ///< that see ground
  double mean_steps = 0;               ///< patches and blocks a ray
  double changed = 0;                  ///< pixels whose b_shadow differs from the first trial's
  std::optional<double> mismatches{};  ///< pixels that differ from the oracle outside the band
  std::optional<double> in_band{};
};

struct Measured {
  double pyramid_seconds = 0;     ///< of level 0
  std::vector<Figure> figures{};  ///< one a trial
};

/// Draws each trial `rounds` times, in turn: A B C A B C ... after one round that warms up, whose images are
/// judged; and oftener, up to 50 times, until all draws together have taken a quarter of a second.
/// Fails with kInterrupted once `interrupted` is set.
[[nodiscard]] Result<Measured> measure(Engine& engine, const Group& group, int rounds,
                                       const std::atomic<bool>& interrupted);

}  // namespace gnomon::bench
