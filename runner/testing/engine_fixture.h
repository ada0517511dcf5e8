// SPDX-License-Identifier: MIT
// What tests of the whole chain share: an engine over the source tree's shaders, and maps to ask it about.
#pragma once

#include <string>

#include "engine.h"

namespace gnomon::testing {

inline Engine make_engine(const std::string& target = "glsl450") {
  return Engine({.shader_library = GNOMON_SOURCE_DIR "/shaderlib", .target = target});
}

/// A scene over a procedural map with 10 m spacing, or over the carried elevation model ("real").
inline scene::Scene scene_over(const std::string& map, int width, int height) {
  scene::Scene scene;
  scene.id = scene.file = map;
  if (map == "real") {
    scene.terrain.source =
        scene::FileTerrain{.path = GNOMON_SOURCE_DIR "/testcases/terrain/jacksboro.png", .channel = {}};
    scene.terrain.spacing = {{74.85, 92.47}};
  } else {
    scene.terrain.source =
        scene::ProceduralTerrain{.kind = map, .width = width, .height = height, .seed = 3, .parameters = {}};
    scene.terrain.spacing = {{10, 10}};
  }
  return scene;
}

}  // namespace gnomon::testing
