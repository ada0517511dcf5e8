// SPDX-License-Identifier: MIT
#include "scene/sun_at_time.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/values.h"

namespace gnomon::scene {

std::optional<MapCentre> map_centre(const Terrain& terrain, const Vocabulary& vocabulary) {
  const auto* file = std::get_if<FileTerrain>(&terrain.source);
  if (!file || file->path.empty() || !vocabulary.map_centre) return std::nullopt;
  return vocabulary.map_centre(*file);
}

namespace {

/// What becomes of the azimuth on the map, for a person.
std::string from_grid_north(const Sun& sun, const std::optional<MapCentre>& centre) {
  if (!centre)
    return ", and the same from grid north (meridian convergence 0: the map names no coordinate system)";
  if (centre->convergence == 0)
    return ", and the same from grid north (meridian convergence 0: the map's columns are meridians)";
  return fmt::format(
      ", {:.5f} from grid north (meridian convergence {:+.5f}: in the middle of the map, grid north lies "
      "{:.5f} degrees {} of true north)",
      sun.azimuth, centre->convergence, std::abs(centre->convergence),
      centre->convergence > 0 ? "clockwise, east" : "counterclockwise, west");
}

}  // namespace

std::optional<SunOnMap> sun_at(const SunTime& time, const std::optional<MapCentre>& centre) {
  if (!time.place && !centre) return std::nullopt;
  const ephemeris::Place place = time.place ? *time.place : centre->place;
  const ephemeris::SunPosition position = ephemeris::sun_position(time.time, place);
  const double lift = time.refraction ? ephemeris::refraction(position.elevation) : 0.0;
  const double convergence = centre ? centre->convergence : 0.0;
  const Sun sun{compass(position.azimuth - convergence), position.elevation + lift, time};
  std::string note =
      fmt::format("sun on {} at latitude {:.10g}, longitude {:.10g}: elevation {:.5f} degrees",
                  ephemeris::to_string(time.time), place.latitude, place.longitude, sun.elevation);
  note += time.refraction ? fmt::format(" (refraction: {:.5f})", lift) : "";
  note += fmt::format(", azimuth {:.5f} from true north", position.azimuth);
  return SunOnMap{sun, note + from_grid_north(sun, centre)};
}

}  // namespace gnomon::scene
