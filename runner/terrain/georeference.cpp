// SPDX-License-Identifier: MIT
#include "terrain/georeference.h"

#include <fmt/format.h>
#include <ogr_srs_api.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace gnomon::terrain {
namespace {

struct Release {
  void operator()(void* crs) const { OSRDestroySpatialReference(crs); }
};
using Crs = std::unique_ptr<void, Release>;

Crs parse(const std::string& wkt) {
  Crs crs(OSRNewSpatialReference(nullptr));
  std::string text = wkt;
  char* begin = text.data();
  if (OSRImportFromWkt(crs.get(), &begin) != OGRERR_NONE) return nullptr;
  return crs;
}

std::string name_of(const Crs& crs) {
  const char* name = OSRGetName(crs.get());
  const std::string text = name ? name : "";
  return text.empty() || text == "unnamed" || text == "unknown" ? "an unnamed coordinate system" : text;
}

std::array<double, 2> cell_of(const Georeference& georeference) {
  return {std::abs(georeference.transform[1]), std::abs(georeference.transform[5])};
}

Result<GeoreferencedSpacing> in_lengths(const Georeference& georeference, const Crs& crs) {
  char* unit_name = nullptr;
  const double unit = OSRGetLinearUnits(crs.get(), &unit_name);
  const auto [x, y] = cell_of(georeference);
  const std::string name = unit_name ? unit_name : "unit";
  const std::string converted =
      unit == 1.0 ? "" : fmt::format(" (cells of {:.10g} x {:.10g} {})", x, y, name);
  return GeoreferencedSpacing{{x * unit, y * unit},
                              fmt::format("spacing {:.10g} x {:.10g} m{}, by the georeference in {}",
                                          x * unit, y * unit, converted, name_of(crs))};
}

Result<GeoreferencedSpacing> in_angles(const Georeference& georeference, int height, const Crs& crs) {
  OGRErr wrong_axis = OGRERR_NONE;
  OGRErr wrong_flattening = OGRERR_NONE;
  const double semi_major = OSRGetSemiMajor(crs.get(), &wrong_axis);
  const double inverse_flattening = OSRGetInvFlattening(crs.get(), &wrong_flattening);
  if (wrong_axis != OGRERR_NONE || wrong_flattening != OGRERR_NONE || !(semi_major > 0))
    return Diagnostic{.message =
                          fmt::format("the coordinate system {} names no ellipsoid, so that its degrees "
                                      "have no length; give --spacing (\"spacing\" in a scene)",
                                      name_of(crs))};
  const double radians = OSRGetAngularUnits(crs.get(), nullptr);
  const double middle = georeference.transform[3] + georeference.transform[5] * height / 2.0;
  const double latitude = middle * radians;
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  if (!(std::abs(latitude) < std::numbers::pi / 2))
    return Diagnostic{.message =
                          fmt::format("the middle of the map lies at latitude {:.10g} degrees, where no map "
                                      "has a spacing; give --spacing (\"spacing\" in a scene)",
                                      latitude * kDegrees)};
  const auto [east, north] = radian_lengths(semi_major, inverse_flattening, latitude);
  const auto [x, y] = cell_of(georeference);
  const std::array metres{x * radians * east, y * radians * north};
  return GeoreferencedSpacing{
      metres,
      fmt::format("spacing {:.10g} x {:.10g} m: cells of {:.10g} x {:.10g} degrees at latitude {:.6g} on "
                  "the ellipsoid of {}",
                  metres[0], metres[1], x * radians * kDegrees, y * radians * kDegrees, latitude * kDegrees,
                  name_of(crs))};
}

}  // namespace

std::array<double, 2> radian_lengths(double semi_major, double inverse_flattening, double latitude_radians) {
  const double flattening = inverse_flattening == 0 ? 0 : 1 / inverse_flattening;
  const double e2 = flattening * (2 - flattening);
  const double s = std::sin(latitude_radians);
  const double normal = semi_major / std::sqrt(1 - e2 * s * s);
  const double meridional = normal * (1 - e2) / (1 - e2 * s * s);
  return {normal * std::cos(latitude_radians), meridional};
}

Result<GeoreferencedSpacing> spacing_of(const Georeference& georeference, int height) {
  if (georeference.crs.empty()) {
    const auto [x, y] = cell_of(georeference);
    return GeoreferencedSpacing{
        {x, y},
        fmt::format(
            "spacing {:.10g} x {:.10g} m: the file names no coordinate system, so its units are taken "
            "as metres; give --spacing if they are not",
            x, y)};
  }
  const Crs crs = parse(georeference.crs);
  if (crs && (OSRIsProjected(crs.get()) || OSRIsLocal(crs.get()))) return in_lengths(georeference, crs);
  if (crs && OSRIsGeographic(crs.get())) return in_angles(georeference, height, crs);
  return Diagnostic{.message =
                        fmt::format("the coordinate system {} is neither projected nor geographic; give "
                                    "--spacing (\"spacing\" in a scene)",
                                    crs ? name_of(crs) : "of the file")};
}

double vertical_unit(const std::string& crs_text) {
  const Crs crs = crs_text.empty() ? nullptr : parse(crs_text);
  if (!crs || !(OSRIsCompound(crs.get()) || OSRIsVertical(crs.get()))) return 1.0;
  return OSRGetTargetLinearUnits(crs.get(), "VERT_CS", nullptr);
}

}  // namespace gnomon::terrain
