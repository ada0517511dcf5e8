// SPDX-License-Identifier: MIT
#include "terrain/ground_scale.h"

#include <fmt/format.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "terrain/graticule.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
/// Half the piece of a row or column that is measured, metres of the projection: short against what the scale
/// changes in, long against the rounding of coordinates.
constexpr double kStep = 100;
/// What is said: a scale beside 1, degrees beside a right angle.
constexpr double kScale = 0.01;
constexpr double kCorner = 1;

using Vector = std::array<double, 3>;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Points of a coordinate system in space, metres from the middle of the ellipsoid: there the poles are
/// places like others.
class Space {
 public:
  Space(const Crs& crs, const Graticule& graticule) : graticule_(graticule) {
    const double inverse_flattening = OSRGetInvFlattening(crs.get(), nullptr);
    const double flattening = inverse_flattening == 0 ? 0 : 1 / inverse_flattening;
    semi_major_ = OSRGetSemiMajor(crs.get(), nullptr);
    e2_ = flattening * (2 - flattening);
  }

  [[nodiscard]] std::optional<Vector> at(Point point) const {
    const std::optional<Point> place = transformed(graticule_.to_geographic, point);
    if (!place) return std::nullopt;
    const double longitude = (*place)[0] * graticule_.unit / kDegrees;
    const double latitude = (*place)[1] * graticule_.unit / kDegrees;
    const double s = std::sin(latitude);
    const double normal = semi_major_ / std::sqrt(1 - e2_ * s * s);
    const double from_axis = normal * std::cos(latitude);
    return Vector{from_axis * std::cos(longitude), from_axis * std::sin(longitude), normal * (1 - e2_) * s};
  }

  /// The way from one point to another.
  [[nodiscard]] std::optional<Vector> way(Point from, Point to) const {
    const std::optional<Vector> a = at(from), b = at(to);
    if (!a || !b) return std::nullopt;
    return Vector{(*b)[0] - (*a)[0], (*b)[1] - (*a)[1], (*b)[2] - (*a)[2]};
  }

 private:
  const Graticule& graticule_;
  double semi_major_ = 0;
  double e2_ = 0;  ///< eccentricity squared
};

/// How long shadows are that are reckoned in metres of the projection.
std::string error_text(double scale) {
  const double percent = 100 * (scale - 1);
  if (std::abs(percent) < 0.05) return "right";
  return fmt::format("{:.1f} % too {}", std::abs(percent), percent < 0 ? "short" : "long");
}

}  // namespace

std::optional<GroundScale> ground_scale(const Georeference& georeference, int width, int height) {
  const Crs crs = horizontal(georeference.crs);
  if (!crs || !OSRIsProjected(crs.get())) return std::nullopt;
  const std::optional<Graticule> graticule = graticule_of(crs);
  if (!graticule) return std::nullopt;
  const Space space(crs, *graticule);
  const auto [x, y] = middle_of(georeference, width, height);
  const double step = kStep / OSRGetLinearUnits(crs.get(), nullptr);
  const std::optional<Vector> row = space.way({x - step, y}, {x + step, y});
  const std::optional<Vector> column = space.way({x, y - step}, {x, y + step});
  if (!row || !column) return std::nullopt;
  const double along_row = std::sqrt(dot(*row, *row));
  const double along_column = std::sqrt(dot(*column, *column));
  if (!(along_row > 0) || !(along_column > 0)) return std::nullopt;
  const double cosine = dot(*row, *column) / (along_row * along_column);
  return GroundScale{{along_row / (2 * kStep), along_column / (2 * kStep)},
                     std::acos(std::clamp(cosine, -1.0, 1.0)) * kDegrees};
}

std::optional<std::string> ground_scale_warning(const Georeference& georeference, int width, int height,
                                                std::array<double, 2> spacing) {
  const std::optional<GroundScale> scale = ground_scale(georeference, width, height);
  if (!scale) return std::nullopt;
  const auto [x, y] = scale->metres;
  if (std::max(std::abs(x - 1), std::abs(y - 1)) <= kScale) return std::nullopt;
  std::string text = fmt::format(
      "warning: in the middle of the map a metre of {} is {:.4f} m on the ground from west to east and "
      "{:.4f} m from north to south, and the spacing is the projection's: shadows come out {} from west to "
      "east, {} from north to south; for distances on the ground give --spacing {:.8g},{:.8g} "
      "(\"spacing\" in a scene)",
      name_of(horizontal(georeference.crs)), x, y, error_text(x), error_text(y), spacing[0] * x,
      spacing[1] * y);
  if (std::abs(scale->corner - 90) > kCorner)
    text += fmt::format(
        "; rows and columns cross at {:.1f} degrees there, which no spacing puts right: warp the map to "
        "another projection, for example with gdalwarp",
        scale->corner);
  return text;
}

}  // namespace gnomon::terrain
