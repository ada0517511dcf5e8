// SPDX-License-Identifier: MIT
// The conventions: directions, the surface and its domain, what counts as shadow, the band.
#include "oracle/oracle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/test_maps.h"

namespace gnomon::oracle {
namespace {

using namespace test;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(GroundDirection, IsExactOnAxesAndDiagonals) {
  const double half = std::sqrt(0.5);
  const double expected[8][2] = {{0, 1},  {half, half},   {1, 0},  {half, -half},
                                 {0, -1}, {-half, -half}, {-1, 0}, {-half, half}};
  for (int turn = -720; turn <= 720; turn += 360) {
    for (int octant = 0; octant < 8; ++octant) {
      const auto direction = ground_direction(45.0 * octant + turn);
      EXPECT_EQ(direction.east, expected[octant][0]) << octant << " " << turn;
      EXPECT_EQ(direction.north, expected[octant][1]) << octant << " " << turn;
    }
  }
}

TEST(GroundDirection, IsClockwiseFromNorth) {
  for (double azimuth = -400; azimuth < 800; azimuth += 7.3) {
    const auto direction = ground_direction(azimuth);
    EXPECT_NEAR(direction.east, std::sin(azimuth * std::numbers::pi / 180), 1e-14);
    EXPECT_NEAR(direction.north, std::cos(azimuth * std::numbers::pi / 180), 1e-14);
  }
}

TEST(SurfaceHeight, IsBilinearAndClampedToTheEdge) {
  Random random(1);
  for (const auto& map :
       {noise_map(random, 7, 5, 10), noise_map(random, 1, 6, 10), noise_map(random, 1, 1, 10)}) {
    for (int i = 0; i < 1000; ++i) {
      const double column = uniform(random, 0, map.width), row = uniform(random, 0, map.height);
      EXPECT_NEAR(surface_height(map.surface(), column, row), double(naive_height(map, column, row)), 1e-13);
    }
    EXPECT_EQ(surface_height(map.surface(), 0, 0), map.at(0, 0));
    EXPECT_EQ(surface_height(map.surface(), map.width, map.height), map.at(map.height - 1, map.width - 1));
    EXPECT_EQ(surface_height(map.surface(), map.width - 0.5, 0.5), map.at(0, map.width - 1));
  }
}

TEST(HorizonSlope, FlatGroundLiesAtEyeLevelForAsLongAsThereIsAny) {
  for (const auto& [width, height] : {std::pair{6, 4}, {1, 9}, {9, 1}, {1, 1}}) {
    const auto map = make_map(width, height, [](int, int) { return 1234.5; });
    const auto at = [&](double column, double row, double azimuth) {
      return horizon_slope(map.surface(), {column, row, 0}, ground_direction(azimuth));
    };
    const double w = width, h = height;
    for (double azimuth = 0; azimuth < 360; azimuth += 15) EXPECT_EQ(at(w / 3, h / 3, azimuth), 0) << azimuth;
    EXPECT_EQ(at(w, h / 2, 90), -kInfinity);
    EXPECT_EQ(at(w, h / 2, 45), -kInfinity);
    EXPECT_EQ(at(w, h / 2, 270), 0);
    EXPECT_EQ(at(0, h / 2, 270), -kInfinity);
    EXPECT_EQ(at(w / 2, 0, 0), -kInfinity);
    EXPECT_EQ(at(w / 2, h, 180), -kInfinity);
    EXPECT_EQ(at(0, 0, 315), -kInfinity);
    EXPECT_EQ(at(0, 0, 135), 0);
    EXPECT_EQ(at(w, 0, 180), 0);  // along the edge of the domain
    EXPECT_EQ(at(w, 0, 0), -kInfinity);
  }
}

TEST(HorizonSlope, FromAboveFlatGroundSeesTheDomainsEdge) {
  const auto map = make_map(8, 8, [](int, int) { return 100; });
  // 3.5 texels of open ground ahead, seen from 7 m.
  EXPECT_DOUBLE_EQ(horizon_slope(map.surface(), {4.5, 2, 7}, ground_direction(90)), -2);
  EXPECT_EQ(horizon_slope(map.surface(), {8, 2, 7}, ground_direction(90)), -kInfinity);
}

TEST(HorizonSlope, NothingIsSeenFromOutsideTheDomainAndEverythingFromUnderTheGround) {
  const auto map = make_map(4, 4, [](int, int) { return 1; });
  EXPECT_EQ(horizon_slope(map.surface(), {-0.1, 2, 0}, ground_direction(90)), -kInfinity);
  EXPECT_EQ(horizon_slope(map.surface(), {2, 4.1, 0}, ground_direction(90)), -kInfinity);
  EXPECT_EQ(horizon_slope(map.surface(), {std::nan(""), 2, 0}, ground_direction(90)), -kInfinity);
  EXPECT_EQ(horizon_slope(map.surface(), {2, 2, -0.1}, ground_direction(90)), kInfinity);
}

TEST(HorizonSlope, TheSurfaceEndsWithTheDomainEvenInsideAPatch) {
  // A ramp 0 .. 10 between samples 0 and 1, seen from 1 m above sample 0: slope 10 - 1/x at x, still rising
  // at the end.
  auto surface = make_map(2, 1, [](int, int column) { return 10 * column; });
  auto view = surface.surface();
  for (const double end : {1.5, 1.25, 0.75}) {
    view.domain_width = end;
    EXPECT_DOUBLE_EQ(horizon_slope(view, {0.5, 0.5, 1}, ground_direction(90)), 10 - 1 / (end - 0.5));
  }
  view.domain_width = 0.5;
  EXPECT_EQ(horizon_slope(view, {0.5, 0.5, 1}, ground_direction(90)), -kInfinity);
}

TEST(InShadow, IsStrictAndFlatModelled) {
  const double quarter = std::numbers::pi / 4;
  EXPECT_FALSE(in_shadow(quarter, 45)) << "a ray that only touches is lit";
  EXPECT_TRUE(in_shadow(std::nextafter(quarter, 1), 45));
  EXPECT_FALSE(in_shadow(std::nextafter(quarter, 0), 45));
  for (const double horizon : {-std::numbers::pi / 2, -0.1, 0.0, 0.3}) {
    EXPECT_TRUE(in_shadow(horizon, 0));
    EXPECT_TRUE(in_shadow(horizon, -1));
  }
  EXPECT_FALSE(in_shadow(std::numbers::pi / 2, 90));
  EXPECT_FALSE(in_shadow(0, 1e-9));
}

TEST(Band, IsNarrowOnlyWhereSinglePrecisionIsSharp) {
  EXPECT_EQ(band_width(true, 0, 50), 1e-5);
  EXPECT_EQ(band_width(true, 0, 50.1), 1e-4);
  EXPECT_EQ(band_width(false, 0, 1), 1e-4);
  EXPECT_EQ(band_width(true, 0.5, 1), 1e-4);
}

TEST(Band, SurroundsTheHorizonButNeverTheCertainAnswers) {
  const double horizon = std::atan(0.2), degrees = horizon * 180 / std::numbers::pi;
  for (const double side : {-1.0, 1.0}) {
    EXPECT_TRUE(in_band(horizon, degrees + side * 0.99e-4 * 180 / std::numbers::pi, 1e-4));
    EXPECT_FALSE(in_band(horizon, degrees + side * 1.01e-4 * 180 / std::numbers::pi, 1e-4));
  }
  EXPECT_FALSE(in_band(0, 0, 1e-4));
  EXPECT_FALSE(in_band(-1e-6, -1e-6, 1e-4));
  EXPECT_FALSE(in_band(std::numbers::pi / 2, 90, 1e-4));
  EXPECT_FALSE(in_band(-std::numbers::pi / 2, 1, 1e-4));
}

TEST(SteepestSlope, IsPerAxisInMetres) {
  auto map = make_map(3, 2, [](int row, int column) { return column == 2 ? -6 : 5 * row; });
  map.spacing_x = 2;
  map.spacing_y = 0.5;
  EXPECT_DOUBLE_EQ(steepest_slope(map.surface()), 10);  // 5 m in 0.5 m, against 11 m in 2 m
  map.spacing_y = 5;
  EXPECT_DOUBLE_EQ(steepest_slope(map.surface()), 5.5);
  EXPECT_EQ(steepest_slope(make_map(1, 1, [](int, int) { return 7; }).surface()), 0);
}

}  // namespace
}  // namespace gnomon::oracle
