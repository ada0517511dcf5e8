// SPDX-License-Identifier: MIT
// Spacing from coordinate systems, against published lengths and against the metre by definition.
#include "terrain/georeference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "terrain/gdal_setup.h"
#include "terrain/units.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class GeoreferenceTest : public testing::Test {
 protected:
  GeoreferenceTest() { set_up_gdal(); }
  GdalMessages silent_;
};

std::string geographic(const std::string& ellipsoid,
                       const std::string& unit = "degree\",0.0174532925199433") {
  return "GEOGCS[\"somewhere\",DATUM[\"d\",SPHEROID[" + ellipsoid + "]],PRIMEM[\"p\",0],UNIT[\"" + unit +
         "]]";
}
const std::string kWgs84 = geographic("\"WGS 84\",6378137,298.257223563");

std::string projected(const std::string& unit) {
  return "PROJCS[\"grid\"," + kWgs84 +
         ",PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],PARAMETER[\"central_"
         "meridian\",9],"
         "PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],PARAMETER[\"false_"
         "northing\",0],"
         "UNIT[" +
         unit + "]]";
}

// Lengths of a degree on WGS 84 as tables print them (NGA, "Length of a degree of latitude and longitude").
TEST_F(GeoreferenceTest, DegreesAreAsLongAsTablesSay) {
  const auto lengths = [](double latitude) {
    const auto [east, north] = radian_lengths(6378137, 298.257223563, latitude * kDegree);
    return std::array{east * kDegree, north * kDegree};
  };
  EXPECT_NEAR(lengths(0)[0], 111319.5, 0.1);
  EXPECT_NEAR(lengths(0)[1], 110574.3, 0.1);
  EXPECT_NEAR(lengths(45)[0], 78846.8, 0.1);
  EXPECT_NEAR(lengths(45)[1], 111131.8, 0.1);
  EXPECT_NEAR(lengths(90)[1], 111693.9, 0.1);
  EXPECT_NEAR(lengths(-45)[0], lengths(45)[0], 1e-9);
}

TEST_F(GeoreferenceTest, ASphereHasOneRadius) {
  const auto [east, north] = radian_lengths(1737400, 0, 60 * kDegree);
  EXPECT_NEAR(east, 1737400 * 0.5, 1e-6);
  EXPECT_NEAR(north, 1737400, 1e-6);
}

TEST_F(GeoreferenceTest, TheMiddleOfTheMapDecides) {
  // 40 rows of a tenth of a degree, from 48 to 44: the middle lies at 46.
  const auto spacing = spacing_of({{9, 0.1, 0, 48, 0, -0.1}, kWgs84}, 40);
  ASSERT_TRUE(spacing.ok());
  const auto [east, north] = radian_lengths(6378137, 298.257223563, 46 * kDegree);
  EXPECT_NEAR(spacing->metres[0], 0.1 * kDegree * east, 1e-6);
  EXPECT_NEAR(spacing->metres[1], 0.1 * kDegree * north, 1e-6);
  EXPECT_NE(spacing->how.find("latitude 46"), std::string::npos) << spacing->how;
}

TEST_F(GeoreferenceTest, TheFilesOwnEllipsoidAndAngleCount) {
  const auto moon = spacing_of({{0, 0.25, 0, 90, 0, -0.25}, geographic("\"Moon\",1737400,0")}, 720);
  ASSERT_TRUE(moon.ok());
  EXPECT_NEAR(moon->metres[0], 1737400 * 0.25 * kDegree, 1e-6);
  EXPECT_NEAR(moon->metres[0], 7580.8, 0.1);  // as the label of LOLA's 4 pixel a degree map says
  const auto grads =
      spacing_of({{0, 1, 0, 0.5, 0, -1}, geographic("\"s\",6371000,0", "grad\",0.01570796326794897")}, 1);
  ASSERT_TRUE(grads.ok());
  EXPECT_NEAR(grads->metres[1], 6371000 * std::numbers::pi / 200, 1e-6);
}

TEST_F(GeoreferenceTest, ProjectedUnitsBecomeMetres) {
  EXPECT_EQ(spacing_of({{0, 30, 0, 0, 0, -20}, projected("\"metre\",1")}, 1)->metres,
            (std::array{30.0, 20.0}));
  const auto feet = spacing_of({{0, 10, 0, 0, 0, -10}, projected("\"foot\",0.3048")}, 1);
  EXPECT_NEAR(feet->metres[0], 3.048, 1e-12);
  EXPECT_NE(feet->how.find("10 x 10 foot"), std::string::npos) << feet->how;
  const auto survey =
      spacing_of({{0, 3937, 0, 0, 0, -3937}, projected("\"US survey foot\",0.304800609601219")}, 1);
  EXPECT_NEAR(survey->metres[0], 1200, 1e-8);
}

TEST_F(GeoreferenceTest, WithoutACoordinateSystemMetresAreSaidToBeAssumed) {
  const auto spacing = spacing_of({{0, 5, 0, 0, 0, -7}, ""}, 1);
  EXPECT_EQ(spacing->metres, (std::array{5.0, 7.0}));
  EXPECT_NE(spacing->how.find("taken as metres"), std::string::npos);
}

TEST_F(GeoreferenceTest, WhatHasNoLengthIsRefusedWithTheWayOut) {
  const std::string geocentric =
      "GEOCCS[\"g\",DATUM[\"d\",SPHEROID[\"WGS "
      "84\",6378137,298.257223563]],PRIMEM[\"p\",0],UNIT[\"metre\",1]]";
  for (const Georeference& georeference :
       {Georeference{{0, 1, 0, 0, 0, -1}, geocentric}, Georeference{{0, 1, 0, 0, 0, -1}, "nonsense"},
        Georeference{{0, 1, 0, 500, 0, -1}, kWgs84}, Georeference{{0, 1, 0, 91, 0, -2}, kWgs84}}) {
    const auto spacing = spacing_of(georeference, 1);
    ASSERT_FALSE(spacing.ok()) << spacing->how;
    EXPECT_NE(spacing.diagnostics()[0].message.find("--spacing"), std::string::npos);
  }
}

/// Rows of `row` degrees southward from `north`.
Result<GeoreferencedSpacing> rows(double north, double row, int height) {
  return spacing_of({{0, row, 0, north, 0, -row}, kWgs84}, height);
}

TEST_F(GeoreferenceTest, ARowBeyondAPoleIsNothingToSpeakOf) {
  for (const auto& [north, row, height] : {std::tuple{90.5, 1.0, 181},
                                           {91.0, 1.0, 100},
                                           {-11.0, 1.0, 80},
                                           {90.0, 0.25, 1},
                                           {90.05, 0.1, 1801}}) {
    const auto spacing = rows(north, row, height);
    ASSERT_TRUE(spacing.ok()) << north << ": " << spacing.diagnostics()[0].message;
    EXPECT_EQ(spacing->warning, "") << north;
    EXPECT_GT(spacing->metres[0], 0);
  }
}

TEST_F(GeoreferenceTest, EdgesBeyondAPoleAreWarnedOf) {
  for (const auto& [north, height, reach] : {std::tuple{91.1, 80, "from latitude 11.1 to 91.1 degrees"},
                                             {-12.0, 80, "from latitude -92 to -12 degrees"},
                                             {100.0, 30, "from latitude 70 to 100 degrees"},
                                             {180.0, 360, "from latitude -180 to 180 degrees"}}) {
    const auto spacing = rows(north, 1, height);
    ASSERT_TRUE(spacing.ok()) << north << ": " << spacing.diagnostics()[0].message;
    EXPECT_EQ(spacing->warning.rfind("warning: ", 0), 0u) << spacing->warning;
    EXPECT_NE(spacing->warning.find(reach), std::string::npos) << spacing->warning;
    EXPECT_NE(spacing->warning.find("--spacing"), std::string::npos);
  }
}

TEST_F(GeoreferenceTest, AMiddleOnOrBeyondAPoleIsRefused) {
  for (const auto& [north, height, says] :
       {std::tuple{120.0, 40, "lies at latitude 100 degrees, not between the poles"},
        {-80.0, 40, "lies at latitude -100 degrees, not between the poles"},
        {100.0, 20, "lies at latitude 90 degrees, not between the poles"},
        {100.0, 21, "lies at latitude 89.5 degrees, less than a row from a pole"},
        {-79.0, 21, "lies at latitude -89.5 degrees, less than a row from a pole"}}) {
    const auto spacing = rows(north, 1, height);
    ASSERT_FALSE(spacing.ok()) << north << ": " << spacing->how;
    const std::string message = spacing.diagnostics()[0].message;
    EXPECT_NE(message.find(says), std::string::npos) << message;
    EXPECT_NE(message.find("--spacing"), std::string::npos);
  }
  EXPECT_TRUE(rows(100, 1, 22).ok()) << "a whole row from the pole";
}

TEST_F(GeoreferenceTest, VerticalUnits) {
  EXPECT_EQ(vertical_unit(""), 1);
  EXPECT_EQ(vertical_unit(kWgs84), 1);
  const std::string feet = "VERT_CS[\"v\",VERT_DATUM[\"d\",2005],UNIT[\"foot\",0.3048],AXIS[\"Up\",UP]]";
  EXPECT_NEAR(vertical_unit("COMPD_CS[\"c\"," + projected("\"metre\",1") + "," + feet + "]"), 0.3048, 1e-15);
  EXPECT_EQ(metres_per("m"), 1);
  EXPECT_EQ(metres_per("Foot"), 0.3048);
  EXPECT_NEAR(*metres_per("US survey foot"), 0.3048006096, 1e-10);
  EXPECT_EQ(metres_per("parsec"), std::nullopt);
  EXPECT_EQ(metres_per(""), std::nullopt);
}

}  // namespace
}  // namespace gnomon::terrain
