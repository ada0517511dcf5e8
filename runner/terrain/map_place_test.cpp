// SPDX-License-Identifier: MIT
// Middle and meridian convergence of maps, against the formulas of their projections.
#include "terrain/map_place.h"

#include <cmath>
#include <numbers>

#include "terrain/gdal_setup.h"
#include "terrain/load_fixture.h"

namespace gnomon::terrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

using MapPlaceTest = LoadFiles;

/// Where a file says that it lies; a place that is none where it does not.
MapPlace place(const std::string& path, const LoadOptions& options = {}) {
  const std::optional<MapPlace> found = height_map_place(path, options);
  EXPECT_TRUE(found) << path;
  return found.value_or(MapPlace{1e9, 1e9, 1e9});
}

/// A map of 40 x 30 samples, 30 m apart, around a point of a coordinate system.
TestFile around(const std::string& crs, double x, double y, double metres = 30) {
  TestFile file = counting(40, 30);
  file.crs = crs;
  file.transform = {{x - 20 * metres, metres, 0, y + 15 * metres, 0, -metres}};
  return file;
}

// Zone 33, central meridian 15 degrees east: x grows eastward, y northward (from 10^7 m in the south).
struct UtmPoint {
  const char* crs;
  double x, y;
  double side;  ///< sign of the convergence
};

TEST_F(MapPlaceTest, ConvergenceOfUtmIsThatOfItsFormula) {
  for (const UtmPoint& point : {UtmPoint{"EPSG:32633", 700000, 5300000, 1},
                                {"EPSG:32633", 300000, 5300000, -1},
                                {"EPSG:32733", 700000, 4700000, -1},
                                {"EPSG:32733", 300000, 4700000, 1}}) {
    const MapPlace found = place(write("m.tif", around(point.crs, point.x, point.y)));
    // On the sphere; the ellipsoid changes less than 2e-5 degrees within a zone.
    const double truth =
        std::atan(std::tan((found.longitude - 15) * kDegree) * std::sin(found.latitude * kDegree)) / kDegree;
    EXPECT_NEAR(found.convergence, truth, 1e-4) << point.crs << ' ' << point.x;
    EXPECT_GT(found.convergence * point.side, 1.5) << point.crs << ' ' << point.x;
    EXPECT_EQ(found.longitude > 15, point.x > 500000);
    EXPECT_EQ(found.latitude > 0, point.y > 5000000);
    EXPECT_NEAR(std::abs(found.latitude), 47.8, 0.1);
  }
  EXPECT_NEAR(place(write("m.tif", around("EPSG:32633", 500000, 5300000))).convergence, 0, 1e-9);
}

TEST_F(MapPlaceTest, SouthUpFilesLieWhereTheirTurnedOnesDo) {
  TestFile file = around("EPSG:32633", 700000, 5300000);
  const MapPlace north_up = place(write("north.tif", file));
  const double south = (*file.transform)[3] - 30 * 30;
  file.transform = {{(*file.transform)[0], 30, 0, south, 0, 30}};
  const MapPlace south_up = place(write("south.tif", file));
  EXPECT_EQ(south_up.latitude, north_up.latitude);
  EXPECT_EQ(south_up.longitude, north_up.longitude);
  EXPECT_EQ(south_up.convergence, north_up.convergence);
}

TEST_F(MapPlaceTest, GeographicMapsHaveNone) {
  const MapPlace found = place(write("m.tif", around("EPSG:4326", 8.5, 47.25, 0.001)));
  EXPECT_NEAR(found.latitude, 47.25, 1e-12) << "EPSG puts the latitude first; a geotransform does not";
  EXPECT_NEAR(found.longitude, 8.5, 1e-12);
  EXPECT_EQ(found.convergence, 0);
  EXPECT_NEAR(place(write("m.tif", around("EPSG:4326", 352, 10, 0.001))).longitude, -8, 1e-9);
}

// EPSG:27572: a conformal cone that touches at 52 grads north, longitudes in grads from Paris.
TEST_F(MapPlaceTest, PrimeMeridiansAndGradsCount) {
  const MapPlace middle = place(write("m.tif", around("EPSG:27572", 600000, 2200000)));
  EXPECT_NEAR(middle.latitude, 46.8, 1e-6);
  EXPECT_NEAR(middle.longitude, 2.33722917, 1e-7);
  EXPECT_NEAR(middle.convergence, 0, 1e-8);
  const MapPlace east = place(write("m.tif", around("EPSG:27572", 900000, 2200000)));
  EXPECT_NEAR(east.convergence, std::sin(46.8 * kDegree) * (east.longitude - 2.33722917), 1e-7);
  EXPECT_GT(east.convergence, 2);
}

TEST_F(MapPlaceTest, NorthingsFirstAndVerticalSystemsChangeNothing) {
  // EPSG:2326 (Hong Kong 1980) has the northing first; 6360 is a height in feet.
  const MapPlace hong_kong = place(write("m.tif", around("EPSG:2326", 836694.05, 819069.80)));
  EXPECT_NEAR(hong_kong.latitude, 22 + 18.0 / 60 + 43.68 / 3600, 1e-6);
  EXPECT_NEAR(hong_kong.longitude, 114 + 10.0 / 60 + 42.80 / 3600, 1e-6);
  const MapPlace flat = place(write("m.tif", around("EPSG:26911", 700000, 3800000)));
  const MapPlace tall = place(write("m.tif", around("EPSG:26911+6360", 700000, 3800000)));
  EXPECT_EQ(tall.latitude, flat.latitude);
  EXPECT_EQ(tall.convergence, flat.convergence);
}

// On a map around the south pole the meridians are straight lines away from it, that of 0 degrees upward.
TEST_F(MapPlaceTest, PolarMapsTurnByTheirLongitude) {
  for (const auto& [x, y] : {std::pair{0.0, 1e6}, {1e6, 0.0}, {-5e5, -5e5}}) {
    const MapPlace south = place(write("m.tif", around("EPSG:3031", x, y)));
    EXPECT_LT(south.latitude, -70);
    EXPECT_NEAR(std::remainder(south.longitude - std::atan2(x, y) / kDegree, 360), 0, 1e-9);
    EXPECT_NEAR(std::remainder(south.convergence + south.longitude, 360), 0, 1e-8);
  }
  const MapPlace pole = place(write("m.tif", around("EPSG:3031", 0, 0)));
  EXPECT_NEAR(pole.latitude, -90, 0.01);
  EXPECT_NEAR(std::remainder(pole.convergence + pole.longitude, 360), 0, 1e-6);
}

TEST_F(MapPlaceTest, IsNothingWhereTheFileDoesNotSay) {
  EXPECT_FALSE(height_map_place(write("plain.tif", counting()), {}));
  TestFile nowhere = around("", 700000, 5300000);
  EXPECT_FALSE(height_map_place(write("nowhere.tif", nowhere), {}));
  EXPECT_FALSE(height_map_place(path("missing.tif"), {}));
  EXPECT_FALSE(height_map_place(write_text("text.tif", "no heights"), {}));
  EXPECT_FALSE(height_map_place(write("off.tif", around("EPSG:4326", 8, 95, 0.01)), {}));
  EXPECT_FALSE(height_map_place(GNOMON_CARRIED_MODEL, {}));
  const std::string moon =
      "GEOGCS[\"Moon\",DATUM[\"Moon\",SPHEROID[\"Moon\",1737400,0]],PRIMEM[\"p\",0],UNIT[\"degree\",0."
      "0174532925199433]]";
  EXPECT_FALSE(height_map_place(write("moon.tif", around(moon, 8, 10, 0.01)), {})) << "no sun of ours";
}

}  // namespace
}  // namespace gnomon::terrain
