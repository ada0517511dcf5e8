// SPDX-License-Identifier: MIT
// A sun that is given by time and place, on a map: the one place where true north becomes grid north.
#pragma once

#include <optional>
#include <string>

#include "scene/load.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// The middle of the scene's height map; nothing where its place on the earth is not known.
[[nodiscard]] std::optional<MapCentre> map_centre(const Terrain& terrain, const Vocabulary& vocabulary);

struct SunOnMap {
  Sun sun;
  std::string note;  ///< for a person: the angles, and what became of the azimuth
};

/// The sun's angles over the map, from grid north. Nothing where neither `time` nor `centre` names a place.
[[nodiscard]] std::optional<SunOnMap> sun_at(const SunTime& time, const std::optional<MapCentre>& centre);

}  // namespace gnomon::scene
