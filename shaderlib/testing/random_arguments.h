// SPDX-License-Identifier: MIT
// Random arguments for module functions: what a walk over a map gives them, and hostile ones.
#ifndef GNOMON_TESTING_RANDOM_ARGUMENTS_H
#define GNOMON_TESTING_RANDOM_ARGUMENTS_H

#include <random>

#include "testing/map_modules.h"

namespace gnomon::modules {

class RandomArguments {
 public:
  RandomArguments(const MapModules& modules, unsigned seed) : modules_(modules), engine_(seed) {}

  [[nodiscard]] const MapModules& modules() const { return modules_; }

  float between(float low, float high);
  bool chance(float probability) { return between(0, 1) < probability; }
  /// 10 to a power between these, of either sign.
  float power_of_ten(float low, float high);
  /// low <= n <= high.
  int whole(int low, int high);

  /// 0 .. extent texels: anywhere, on samples, on and beside the edges of texels and of the map.
  float coordinate(float extent);
  /// 0 .. 1 in a patch, the ends often.
  float fraction();
  /// Metres above the ground, 0 often.
  float height_above_ground();
  /// A patch of the map, the half patches at its edge included.
  ivec2 patch_index();

  /// The test's map with any spacing.
  Modules::GnomonMap map();
  Modules::GnomonReceiver receiver();
  /// A unit vector above the plane and not at the zenith; the axes and diagonals often.
  vec3 sun();
  /// Likewise, but any: below the plane, in it, at the zenith.
  vec3 any_sun();
  Modules::GnomonRay ray();
  Modules::GnomonPatch patch();
  Modules::GnomonCrossing crossing();
  /// Metres, <= 0; often such that the surface just touches the ray at the exit or at the parabola's top.
  float clearance(const Modules::GnomonCrossing& crossing, float crossed);
  /// Between the last float that is in shadow and the first that is lit.
  vec3 sun_at_horizon(const Modules::GnomonMap& map, const Modules::GnomonReceiver& receiver);

  /// Where a view ray of the map begins, and its direction: from all around it, down on it, under it.
  struct View {
    vec3 origin;     ///< metres
    vec3 direction;  ///< of any length
  };
  View view(const Modules::GnomonMap& map);

  /// A ray and a block of 2^level x 2^level patches that it crosses.
  struct Place {
    Modules::GnomonRay ray;
    Modules::GnomonCursor cursor;  ///< in the block, where the ray enters it or later
    ivec2 low;
    int level;
    vec2 exits;
  };
  /// At a level up to this one.
  Place place(int top_level);

 private:
  const MapModules& modules_;
  std::mt19937 engine_;
};

}  // namespace gnomon::modules

#endif
