// SPDX-License-Identifier: MIT
#include "terrain/map_place.h"

#include <ogr_srs_api.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>

#include "terrain/gdal_setup.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Half the piece of the meridian whose direction is taken, degrees: some 100 m, short against its curvature
/// and long against the rounding of coordinates.
constexpr double kStep = 0.001;
/// At a pole every direction is north. A map around it is asked a little beside it, where the sun's azimuth
/// and the convergence count from the same meridian.
constexpr double kHighestLatitude = 90 - 2 * kStep;

struct ReleaseCrs {
  void operator()(void* crs) const { OSRDestroySpatialReference(crs); }
};
using Crs = std::unique_ptr<void, ReleaseCrs>;

struct ReleaseTransformation {
  void operator()(OGRCoordinateTransformationH transformation) const {
    OCTDestroyCoordinateTransformation(transformation);
  }
};
using Transformation =
    std::unique_ptr<std::remove_pointer_t<OGRCoordinateTransformationH>, ReleaseTransformation>;

/// The horizontal part of a coordinate system, with x (east, longitude) before y (north, latitude), as in a
/// geotransform, whatever order the authority has.
Crs horizontal(const std::string& wkt) {
  Crs crs(OSRNewSpatialReference(nullptr));
  std::string text = wkt;
  char* begin = text.data();
  if (text.empty() || OSRImportFromWkt(crs.get(), &begin) != OGRERR_NONE) return nullptr;
  if (OSRIsCompound(crs.get()) && OSRStripVertical(crs.get()) != OGRERR_NONE) return nullptr;
  OSRSetAxisMappingStrategy(crs.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

/// By the size of its ellipsoid, within a percent: the sun of another body stands elsewhere.
bool is_of_the_earth(const Crs& crs) {
  OGRErr error = OGRERR_NONE;
  const double semi_major = OSRGetSemiMajor(crs.get(), &error);
  return error == OGRERR_NONE && std::abs(semi_major / 6378137 - 1) < 0.01;
}

using Point = std::array<double, 2>;

std::optional<Point> transformed(const Transformation& transformation, Point point) {
  double z = 0;
  const bool done = OCTTransform(transformation.get(), 1, &point[0], &point[1], &z) != 0;
  if (!done || !std::isfinite(point[0]) || !std::isfinite(point[1])) return std::nullopt;
  return point;
}

/// Longitude and latitude in degrees, counted from the system's own prime meridian, and back.
struct Graticule {
  Transformation to_geographic;
  Transformation from_geographic;
  double unit = 1;            ///< degrees
  double prime_meridian = 0;  ///< degrees east of Greenwich
};

std::optional<Graticule> graticule_of(const Crs& crs) {
  const Crs geographic(OSRCloneGeogCS(crs.get()));
  if (!geographic) return std::nullopt;
  OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
  Graticule graticule{Transformation(OCTNewCoordinateTransformation(crs.get(), geographic.get())),
                      Transformation(OCTNewCoordinateTransformation(geographic.get(), crs.get())),
                      OSRGetAngularUnits(geographic.get(), nullptr) * kDegrees,
                      OSRGetPrimeMeridian(geographic.get(), nullptr)};
  if (!graticule.to_geographic || !graticule.from_geographic) return std::nullopt;
  return graticule;
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
  const auto& t = georeference.transform;
  const std::optional<Point> middle =
      transformed(graticule->to_geographic, {t[0] + t[1] * width / 2, t[3] + t[5] * height / 2});
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
