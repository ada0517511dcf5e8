// SPDX-License-Identifier: MIT
#include "terrain/map_place.h"

#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrain/graticule.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Half the piece of the meridian whose direction is taken, degrees: some 100 m, short against its curvature
/// and long against the rounding of coordinates.
constexpr double kStep = 0.001;
/// At a pole every direction is north. A map around it is asked a little beside it, where the sun's azimuth
/// and the convergence count from the same meridian.
constexpr double kHighestLatitude = 90 - 2 * kStep;

/// By the size of its ellipsoid, within a percent: the sun of another body stands elsewhere.
bool is_of_the_earth(const Crs& crs) {
  OGRErr error = OGRERR_NONE;
  const double semi_major = OSRGetSemiMajor(crs.get(), &error);
  return error == OGRERR_NONE && std::abs(semi_major / 6378137 - 1) < 0.01;
}

/// Degrees from true north clockwise to grid north at a place of the graticule, degrees: against the
/// direction that the meridian has on the grid.
std::optional<double> convergence_at(const Graticule& graticule, double longitude, double latitude) {
  const auto on_grid = [&](double north) {
    return transformed(graticule.from_geographic,
                       {longitude / graticule.unit, (latitude + north) / graticule.unit});
  };
  const std::optional<Point> north = on_grid(kStep);
  const std::optional<Point> south = on_grid(-kStep);
  if (!north || !south || *north == *south) return std::nullopt;
  return -std::atan2((*north)[0] - (*south)[0], (*north)[1] - (*south)[1]) * kDegrees;
}

/// In [-180, 180).
double wrapped(double longitude) {
  return longitude - 360 * std::floor((longitude + 180) / 360);
}

}  // namespace

std::optional<MapPlace> place_of(const Georeference& georeference, int width, int height) {
  const Crs crs = horizontal(georeference.crs);
  if (!crs || !(OSRIsProjected(crs.get()) || OSRIsGeographic(crs.get())) || !is_of_the_earth(crs))
    return std::nullopt;
  const std::optional<Graticule> graticule = graticule_of(crs);
  if (!graticule) return std::nullopt;
  const std::optional<Point> middle =
      transformed(graticule->to_geographic, middle_of(georeference, width, height));
  if (!middle) return std::nullopt;
  const double longitude = (*middle)[0] * graticule->unit;
  const double latitude = (*middle)[1] * graticule->unit;
  if (std::abs(latitude) > 90) return std::nullopt;
  MapPlace place{latitude, wrapped(longitude + graticule->prime_meridian), 0};
  if (OSRIsGeographic(crs.get())) return place;  // its columns are meridians
  place.latitude = std::clamp(latitude, -kHighestLatitude, kHighestLatitude);
  const std::optional<double> convergence = convergence_at(*graticule, longitude, place.latitude);
  if (!convergence) return std::nullopt;
  place.convergence = *convergence;
  return place;
}

}  // namespace gnomon::terrain
