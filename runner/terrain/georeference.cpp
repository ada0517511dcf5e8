// SPDX-License-Identifier: MIT
#include "terrain/georeference.h"

#include <fmt/format.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrain/graticule.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

Crs parse(const std::string& wkt) {
  Crs crs(OSRNewSpatialReference(nullptr));
  std::string text = wkt;
  char* begin = text.data();
  if (OSRImportFromWkt(crs.get(), &begin) != OGRERR_NONE) return nullptr;
  return crs;
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
                                          x * unit, y * unit, converted, name_of(crs)),
                              {}};
}

/// Degrees, less than what angular units round to: on the pole itself.
constexpr double kPole = 90 - 1e-9;

/// How far a geographic map reaches, degrees.
struct Latitudes {
  double north, middle, south;
  double row;  ///< height of a row

  Latitudes(const Georeference& georeference, int height, double unit)
      : north(georeference.transform[3] * unit),
        middle((georeference.transform[3] + georeference.transform[5] * height / 2.0) * unit),
        south((georeference.transform[3] + georeference.transform[5] * height) * unit),
        row(std::abs(georeference.transform[5]) * unit) {}

  /// Grids whose outermost samples lie on the poles reach half a row beyond them.
  [[nodiscard]] bool beyond_a_pole() const { return std::max(north, -south) - 90 > row * (1 + 1e-6); }
  /// Whether the middle, whose circle of latitude gives the columns their width, is no place between the
  /// poles; or one that lies within a row of a pole by a georeference that leads beyond it, so that the width
  /// is next to nothing.
  [[nodiscard]] bool middle_is_off() const {
    return !(std::abs(middle) < kPole) || (beyond_a_pole() && std::abs(middle) + row > 90);
  }
};

Diagnostic middle_is_off(const Latitudes& latitudes) {
  const bool beyond = !(std::abs(latitudes.middle) < kPole);
  return {.message = fmt::format(
              "the middle of the map lies at latitude {:.10g} degrees, {}, as its rows reach from latitude "
              "{:.10g} to {:.10g}: its columns have no width there; correct the georeference, or give "
              "--spacing (\"spacing\" in a scene)",
              latitudes.middle, beyond ? "not between the poles" : "less than a row from a pole",
              latitudes.south, latitudes.north)};
}

std::string warning_of(const Latitudes& latitudes) {
  if (!latitudes.beyond_a_pole()) return {};
  return fmt::format(
      "warning: the rows of the map reach from latitude {:.10g} to {:.10g} degrees, more than a row beyond a "
      "pole: its georeference cannot be right, nor the spacing by it; correct it, or give --spacing "
      "(\"spacing\" in a scene)",
      latitudes.south, latitudes.north);
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
  const Latitudes latitudes(georeference, height, radians * kDegrees);
  if (latitudes.middle_is_off()) return middle_is_off(latitudes);
  const auto [east, north] = radian_lengths(semi_major, inverse_flattening, latitudes.middle / kDegrees);
  const auto [x, y] = cell_of(georeference);
  const std::array metres{x * radians * east, y * radians * north};
  return GeoreferencedSpacing{
      metres,
      fmt::format("spacing {:.10g} x {:.10g} m: cells of {:.10g} x {:.10g} degrees at latitude {:.6g} on "
                  "the ellipsoid of {}",
                  metres[0], metres[1], x * radians * kDegrees, y * radians * kDegrees, latitudes.middle,
                  name_of(crs)),
      warning_of(latitudes)};
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
            x, y),
        {}};
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
