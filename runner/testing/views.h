// SPDX-License-Identifier: MIT
// Cameras over maps, from where they show what goes wrong: grazing, far away, inside a gorge.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "testing/engine_fixture.h"

namespace gnomon::testing {

struct Seen {
  const char* name;
  const char* map;
  scene::ViewCamera camera;
};

inline scene::ViewCamera perspective(std::array<double, 3> eye, std::array<double, 3> target, double fov,
                                     std::array<int, 2> size) {
  return {.projection = scene::ViewCamera::Projection::kPerspective,
          .eye = eye,
          .target = target,
          .extent = fov,
          .size = size};
}

inline scene::ViewCamera orthographic(std::array<double, 3> eye, std::array<double, 3> target, double height,
                                      std::array<int, 2> size) {
  return {.projection = scene::ViewCamera::Projection::kOrthographic,
          .eye = eye,
          .target = target,
          .extent = height,
          .size = size};
}

/// The view's name as GoogleTest takes it.
inline std::string test_name(const Seen& seen) {
  std::string name = seen.name;
  std::replace(name.begin(), name.end(), ' ', '_');
  return name;
}

/// Maps of 333 x 200 samples, 10 m apart.
inline std::vector<Seen> views() {
  return {
      {"from above", "fractal", perspective({1600, 900, 4000}, {1700, 1100, 0}, 40, {480, 300})},
      {"straight down", "fractal", perspective({1600, 900, 3000}, {1600, 900, 0}, 40, {320, 200})},
      {"grazing", "fractal", perspective({-400, 900, 700}, {3000, 1000, 300}, 30, {480, 200})},
      {"100 km away", "fractal", perspective({-90000, -40000, 9000}, {1660, 1000, 200}, 1.5, {480, 300})},
      {"gorge", "gorge", perspective({1650, 1000, 400}, {2600, 1300, 100}, 60, {480, 300})},
      {"oblique parallel", "gorge", orthographic({4000, -3000, 3000}, {1660, 1000, 0}, 2400, {480, 300})},
      {"parallel straight down", "steps", orthographic({1660, 1000, 900}, {1660, 1000, 0}, 1900, {333, 190})},
      {"spikes", "spikes", perspective({300, -800, 600}, {1700, 1000, 100}, 45, {480, 300})},
      {"real", "real", perspective({12000, -9000, 9000}, {12900, 18000, 300}, 45, {480, 300})},
  };
}

inline scene::Scene scene_of(const Seen& seen) {
  scene::Scene scene = scene_over(seen.map, 333, 200);
  scene.camera = seen.camera;
  scene.sun = {301.3, 11};
  return scene;
}

}  // namespace gnomon::testing
