// SPDX-License-Identifier: MIT
#include "terrain/graticule.h"

#include <ogr_srs_api.h>

#include <cmath>
#include <numbers>

namespace gnomon::terrain {

void ReleaseCrs::operator()(void* crs) const {
  OSRDestroySpatialReference(crs);
}

void ReleaseTransformation::operator()(void* transformation) const {
  OCTDestroyCoordinateTransformation(static_cast<OGRCoordinateTransformationH>(transformation));
}

Crs horizontal(const std::string& wkt) {
  Crs crs(OSRNewSpatialReference(nullptr));
  std::string text = wkt;
  char* begin = text.data();
  if (text.empty() || OSRImportFromWkt(crs.get(), &begin) != OGRERR_NONE) return nullptr;
  if (OSRIsCompound(crs.get()) && OSRStripVertical(crs.get()) != OGRERR_NONE) return nullptr;
  OSRSetAxisMappingStrategy(crs.get(), OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string name_of(const Crs& crs) {
  const char* name = OSRGetName(crs.get());
  const std::string text = name ? name : "";
  return text.empty() || text == "unnamed" || text == "unknown" ? "an unnamed coordinate system" : text;
}

std::optional<Point> transformed(const Transformation& transformation, Point point) {
  double z = 0;
  const bool done = OCTTransform(static_cast<OGRCoordinateTransformationH>(transformation.get()), 1,
                                 &point[0], &point[1], &z) != 0;
  if (!done || !std::isfinite(point[0]) || !std::isfinite(point[1])) return std::nullopt;
  return point;
}

std::optional<Graticule> graticule_of(const Crs& crs) {
  const Crs geographic(OSRCloneGeogCS(crs.get()));
  if (!geographic) return std::nullopt;
  OSRSetAxisMappingStrategy(geographic.get(), OAMS_TRADITIONAL_GIS_ORDER);
  Graticule graticule{Transformation(OCTNewCoordinateTransformation(crs.get(), geographic.get())),
                      Transformation(OCTNewCoordinateTransformation(geographic.get(), crs.get())),
                      OSRGetAngularUnits(geographic.get(), nullptr) * 180.0 / std::numbers::pi,
                      OSRGetPrimeMeridian(geographic.get(), nullptr)};
  if (!graticule.to_geographic || !graticule.from_geographic) return std::nullopt;
  return graticule;
}

Point middle_of(const Georeference& georeference, int width, int height) {
  const auto& t = georeference.transform;
  return {t[0] + t[1] * width / 2, t[3] + t[5] * height / 2};
}

}  // namespace gnomon::terrain
