// SPDX-License-Identifier: MIT
// How long a projected metre is on the ground, against the formulas of projections (Snyder, Map Projections:
// A Working Manual, 1987), and what is said of it.
#include "terrain/ground_scale.h"

#include <cmath>
#include <numbers>
#include <tuple>

#include "terrain/gdal_setup.h"
#include "terrain/load_fixture.h"
#include "terrain/map_place.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kSemiMajor = 6378137;  // WGS 84 and GRS 80, whose flattening is equal to 8 digits
constexpr double kE2 = 2 / 298.257223563 - 1 / (298.257223563 * 298.257223563);

using GroundScaleTest = LoadFiles;

/// A map of 40 x 30 samples, 10 x 20 units apart, around a point of a coordinate system.
TestFile around(const std::string& crs, double x, double y) {
  TestFile file = counting(40, 30);
  file.crs = crs;
  file.transform = {{x - 200, 10, 0, y + 300, 0, -20}};
  return file;
}

struct Loaded {
  GroundScale scale;
  LoadedHeightMap map;
  double latitude = 0;   ///< degrees
  double longitude = 0;  ///< degrees

  [[nodiscard]] std::string warnings() const {
    std::string text;
    for (const std::string& note : map.notes)
      if (note.rfind("warning: ", 0) == 0) text += note + "\n";
    return text;
  }
};

Loaded load(const std::string& path) {
  auto map = load_height_map(path, {});
  EXPECT_TRUE(map.ok()) << path;
  const GdalMessages silent;
  const auto scale = ground_scale(*map->georeference, map->map.width, map->map.height);
  const auto place = height_map_place(path, {});
  EXPECT_TRUE(scale && place) << path;
  return {scale.value_or(GroundScale{{0, 0}, 0}), std::move(map).value(), place->latitude, place->longitude};
}

/// The two numbers behind --spacing in a text.
std::array<double, 2> advised(const std::string& text) {
  const std::size_t at = text.find("--spacing ");
  if (at == std::string::npos) return {0, 0};
  const std::size_t comma = text.find(',', at);
  return {std::stod(text.substr(at + 10)), std::stod(text.substr(comma + 1))};
}

double northing_of_web_mercator(double latitude) {
  return kSemiMajor * std::asinh(std::tan(latitude * kDegree));
}

/// Radii of a circle of latitude and of the meridian, metres.
std::array<double, 2> radii(double latitude) {
  return radian_lengths(kSemiMajor, 298.257223563, latitude * kDegree);
}

// x = a longitude, y = a asinh(tan(latitude)), whatever the ellipsoid: dy = a / cos(latitude) dlatitude.
TEST_F(GroundScaleTest, OfWebMercatorIsThatOfItsFormula) {
  for (const double latitude : {60.0, -60.0, 20.0, 75.0}) {
    const Loaded loaded = load(write("m.tif", around("EPSG:3857", 1e6, northing_of_web_mercator(latitude))));
    const auto [parallel, meridian] = radii(latitude);
    const double x = parallel / kSemiMajor;
    const double y = meridian * std::cos(latitude * kDegree) / kSemiMajor;
    EXPECT_NEAR(loaded.scale.metres[0], x, 1e-8) << latitude;
    EXPECT_NEAR(loaded.scale.metres[1], y, 1e-8) << latitude;
    EXPECT_NEAR(loaded.scale.corner, 90, 1e-6);
    EXPECT_EQ(loaded.map.map.spacing_x, 10) << "the projection's, all the same";
    EXPECT_EQ(loaded.map.map.spacing_y, 20);
    const std::array<double, 2> spacing = advised(loaded.warnings());
    EXPECT_NEAR(spacing[0], 10 * x, 1e-6) << loaded.warnings();
    EXPECT_NEAR(spacing[1], 20 * y, 1e-6) << loaded.warnings();
  }
}

TEST_F(GroundScaleTest, IsSaidOnceWithItsShareAndTheWayOut) {
  const std::string path = write("m.tif", around("EPSG:3857", 1e6, northing_of_web_mercator(60)));
  const std::string text = load(path).warnings();
  EXPECT_SAYS(text, "WGS 84 / Pseudo-Mercator is 0.5013 m on the ground from west to east and 0.5004 m");
  EXPECT_SAYS(text,
              "shadows come out 49.9 % too short from west to east, 50.0 % too short from north to south");
  EXPECT_EQ(text.find('\n'), text.size() - 1);
  EXPECT_EQ(text.find("gdalwarp"), std::string::npos) << "its rows and columns cross at right angles";
  const auto given = load_height_map(path, {.spacing = {{5, 5}}});
  ASSERT_LOADS(given);
  EXPECT_TRUE(given->notes.empty()) << notes(*given);
}

TEST_F(GroundScaleTest, OfUtmDeservesNoWord) {
  for (const double x : {500000.0, 750000.0}) {
    const Loaded loaded = load(write("m.tif", around("EPSG:32633", x, 6650000)));
    EXPECT_EQ(loaded.warnings(), "");
    // Snyder 8-11 to three terms: the scale grows by half the square of the way from the central meridian.
    const auto [parallel, meridian] = radii(loaded.latitude);
    const double radius2 = parallel / std::cos(loaded.latitude * kDegree) * meridian;
    const double way = (x - 500000) / 0.9996;
    const double k = 0.9996 * (1 + way * way / (2 * radius2));
    EXPECT_NEAR(loaded.scale.metres[0], 1 / k, 1e-6);
    EXPECT_NEAR(loaded.scale.metres[1], 1 / k, 1e-6);
  }
}

/// Snyder 14-15 and 15-9: m and t of a conformal cone.
double m_of(double latitude) {
  const double s = std::sin(latitude * kDegree);
  return std::cos(latitude * kDegree) / std::sqrt(1 - kE2 * s * s);
}
double t_of(double latitude) {
  const double e = std::sqrt(kE2);
  const double s = e * std::sin(latitude * kDegree);
  return std::tan((45 - latitude / 2) * kDegree) / std::pow((1 - s) / (1 + s), e / 2);
}

// EPSG:3034: Europe on a cone that cuts the ellipsoid at 35 and 65 degrees north, northings first.
TEST_F(GroundScaleTest, OfAConformalConeIsThatOfItsFormulaInAllDirections) {
  for (const auto& [x, y, speaks] : {std::tuple{4000000.0, 2800000.0, true}, {4000000.0, 950000.0, false}}) {
    const Loaded loaded = load(write("m.tif", around("EPSG:3034", x, y)));
    const double n = std::log(m_of(35) / m_of(65)) / std::log(t_of(35) / t_of(65));
    const double k = m_of(35) / m_of(loaded.latitude) * std::pow(t_of(loaded.latitude) / t_of(35), n);
    EXPECT_NEAR(loaded.scale.metres[0], 1 / k, 1e-8) << loaded.latitude;
    EXPECT_NEAR(loaded.scale.metres[1], 1 / k, 1e-8) << loaded.latitude;
    EXPECT_EQ(std::abs(1 / k - 1) > 0.01, speaks) << k;
    EXPECT_EQ(!loaded.warnings().empty(), speaks) << loaded.warnings();
    if (speaks) {
      EXPECT_SAYS(loaded.warnings(), "too long from west to east");
    }
  }
}

TEST_F(GroundScaleTest, AtAPoleIsLikeElsewhere) {
  // EPSG:3031: true at 71 degrees south; at the pole Snyder 21-33 with 21-35 and 21-40.
  const auto map = load_height_map(write("m.tif", around("EPSG:3031", 0, 0)), {});
  ASSERT_LOADS(map);
  const double e = std::sqrt(kE2);
  const double k = m_of(71) / t_of(71) / 2 * std::sqrt(std::pow(1 + e, 1 + e) * std::pow(1 - e, 1 - e));
  const auto scale = ground_scale(*map->georeference, 40, 30);
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->metres[0], 1 / k, 1e-8);
  EXPECT_NEAR(scale->metres[1], 1 / k, 1e-8);
  EXPECT_SAYS(notes(*map), "2.8 % too long");
}

TEST_F(GroundScaleTest, CountsInTheUnitOfTheProjection) {
  // EPSG:2225, California zone 1, in US survey feet: true to 1 in 10,000 within its zone.
  const Loaded loaded = load(write("m.tif", around("EPSG:2225", 6561666, 1968500)));
  EXPECT_NEAR(loaded.scale.metres[0], 1, 2e-4);
  EXPECT_NEAR(loaded.scale.metres[1], 1, 2e-4);
  EXPECT_EQ(loaded.warnings(), "");
}

// Sinusoidal: x = longitude times the radius of the parallel, so that columns lean on it the farther out.
TEST_F(GroundScaleTest, ObliqueCornersAreSaidToo) {
  const double x = radii(45)[0] * 60 * kDegree;
  const Loaded loaded = load(write("m.tif", around("+proj=sinu +ellps=WGS84", x, 4984944)));
  const double lean = loaded.longitude * kDegree * std::sin(loaded.latitude * kDegree);
  EXPECT_NEAR(loaded.scale.metres[0], 1, 1e-8);
  EXPECT_NEAR(loaded.scale.metres[1], std::hypot(1, lean), 1e-6);
  EXPECT_NEAR(loaded.scale.corner, std::atan2(1, lean) / kDegree, 1e-5);
  EXPECT_SAYS(loaded.warnings(), "shadows come out right from west to east");
  EXPECT_SAYS(loaded.warnings(), "cross at 53.");
  EXPECT_SAYS(loaded.warnings(), "gdalwarp");
}

TEST_F(GroundScaleTest, IsNothingWithoutAProjection) {
  for (const std::string crs : {"EPSG:4326", ""}) {
    TestFile file = around(crs, 0, 0);
    file.transform = {{8, 0.01, 0, 47, 0, -0.01}};
    const auto map = load_height_map(write("m.tif", file), {});
    ASSERT_LOADS(map);
    EXPECT_FALSE(ground_scale(*map->georeference, 40, 30)) << crs;
    EXPECT_EQ(map->notes.size(), 1u) << notes(*map);
  }
}

}  // namespace
}  // namespace gnomon::terrain
