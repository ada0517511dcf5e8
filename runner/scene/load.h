// SPDX-License-Identifier: MIT
// From a scene file to the tests it makes: parse, --set, matrix, validate; every error at once.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// Where the middle of a height map lies, by its georeference.
struct MapCentre {
  ephemeris::Place place;
  /// Meridian convergence there: degrees from true north clockwise to grid north.
  double convergence = 0;
};

/// Names that a scene may use but that other libraries own, and what they know of terrain files.
struct Vocabulary {
  std::vector<std::string> methods;  ///< shadow methods
  std::map<std::string, std::vector<std::string>>
      kinds;                          ///< procedural maps: kind -> names of its parameters
  std::vector<std::string> channels;  ///< that probes and tolerances may name; empty: any
  /// Width and height of a terrain file in samples, if it can tell cheaply. Unset or nullopt: what depends on
  /// the size (shadow.q, levels, probes) is left to `check_size`.
  std::function<std::optional<std::array<int, 2>>(const FileTerrain&)> file_size;
  /// The middle of a terrain file, if it has a georeference. Unset or nullopt: a sun by time needs a place,
  /// and its azimuth from true north is taken for that from grid north.
  std::function<std::optional<MapCentre>(const FileTerrain&)> map_centre;
};

/// Either tests or errors: nothing is rendered from an invalid scene.
struct LoadResult {
  std::vector<Scene> tests;  ///< one for each combination of the matrix, the last key running fastest
  Diagnostics diagnostics;   ///< located, in the order of the file
};

/// Loads a scene file, with `overrides` (KEY=VALUE, as given to --set).
[[nodiscard]] LoadResult load_scene(const std::string& path, const std::vector<std::string>& overrides,
                                    const Vocabulary& vocabulary);

/// What is wrong with a scene once the size of its height map (in samples) is known: a level beyond the
/// coarsest, a probe outside the image. Located by file and JSON pointer only.
[[nodiscard]] Diagnostics check_size(const Scene& scene, int width, int height);

}  // namespace gnomon::scene
