// SPDX-License-Identifier: MIT
// Shadows with an exact answer: docs/algorithms.md, "Analytic ground truths".
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "oracle/oracle.h"
#include "oracle/test_maps.h"

namespace gnomon::oracle {
namespace {

using namespace test;

double slope(const Map& map, const Receiver& receiver, double azimuth) {
  return horizon_slope(map.surface(), receiver, ground_direction(azimuth));
}

double tangent(double degrees) {
  return std::tan(degrees * std::numbers::pi / 180);
}

/// Whether the receiver lies in shadow, asked the way users ask.
bool shaded(const Map& map, const Receiver& receiver, double azimuth, double elevation) {
  return in_shadow(std::atan(slope(map, receiver, azimuth)), elevation);
}

TEST(Step, ShadowEndsAtHeightOverTangent) {
  constexpr double kHeight = 20;
  auto map = make_map(64, 3, [](int, int column) { return column >= 40 ? kHeight : 0; });
  map.spacing_x = 2.5;
  const double edge = 40.5;  // texel at which the step reaches its full height
  for (const double elevation : {12.0, 20.0, 45.0, 60.0}) {
    const double length = kHeight / tangent(elevation) / map.spacing_x;  // texels
    for (const double row : {0.5, 1.0, 1.5, 1.73}) {
      EXPECT_TRUE(shaded(map, {edge - length * (1 - 1e-9), row, 0}, 90, elevation));
      EXPECT_FALSE(shaded(map, {edge - length * (1 + 1e-9), row, 0}, 90, elevation));
      EXPECT_FALSE(shaded(map, {edge - length * (1 - 1e-9), row, 0}, 270, elevation));
    }
  }
  EXPECT_FALSE(shaded(map, {edge + 0.01, 1.5, 0}, 90, 0.01)) << "the plateau itself is lit";
}

TEST(Wall, ShadowSpansTheSunsAzimuth) {
  constexpr double kHeight = 8;
  const auto map = make_map(101, 101, [](int row, int) { return row == 30 ? kHeight : 0; });
  for (const double azimuth : {0.0, 25.0, -45.0, 45.0, 60.0}) {
    for (const double south : {1.5, 2.0, 7.25, 20.1}) {  // texels south of the wall's crest
      const double distance = south / std::cos(azimuth * std::numbers::pi / 180);
      EXPECT_NEAR(slope(map, {50.5, 30.5 + south, 0}, azimuth), kHeight / distance, 1e-13);
    }
  }
}

TEST(Plane, ShadesItselfExactlyWhenItRisesFasterThanTheRay) {
  constexpr double kEast = 0.75,
                   kSouth = -0.5;  // slope per metre; a plane in binary fractions is exact in float
  auto map =
      make_map(40, 30, [](int row, int column) { return 4096 + kEast * column * 2 + kSouth * row * 4; });
  map.spacing_x = 2;
  map.spacing_y = 4;
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const double azimuth = random_azimuth(random);
    const auto direction = ground_direction(azimuth);
    const double rise_east = kEast * direction.east, rise_north = -kSouth * direction.north;
    // Where an axis runs downhill, the flat rim beyond its last sample stands above the plane and may be what
    // is seen.
    if (rise_east < 0 || rise_north < 0) continue;
    const double rise = rise_east + rise_north;
    const Receiver receiver{uniform(random, 0.5, 39), uniform(random, 1, 29.5), 0};
    EXPECT_NEAR(slope(map, receiver, azimuth), rise, 1e-12);
    const double elevation = std::atan(rise) * 180 / std::numbers::pi;
    EXPECT_TRUE(shaded(map, receiver, azimuth, elevation - 1e-9));
    EXPECT_FALSE(shaded(map, receiver, azimuth, elevation + 1e-9));
  }
}

TEST(Plane, ExactlyAlongTheRayIsLit) {
  const auto map = make_map(50, 50, [](int, int column) { return 1000 + column; });
  for (const double column : {0.5, 3.0, 7.25, 20.5, 48.0}) {
    for (const double row : {0.0, 0.5, 11.0, 30.125}) {
      EXPECT_EQ(slope(map, {column, row, 0}, 90), 1);
      EXPECT_FALSE(shaded(map, {column, row, 0}, 90, 45));
      EXPECT_TRUE(shaded(map, {column, row, 0}, 90, 45 - 1e-12));
    }
  }
}

TEST(Plane, FacingTheSunIsLit) {
  const auto map = make_map(50, 50, [](int row, int column) { return -2.0 * column + 0.5 * row; });
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Receiver receiver{uniform(random, 0, 50), uniform(random, 0, 50), 0};
    EXPECT_FALSE(shaded(map, receiver, uniform(random, 20, 80), 1e-6));
  }
}

class Cone : public testing::Test {
 protected:
  static constexpr int kSize = 241, kApex = 120;
  static constexpr double kHeight = 40, kFoot = 30;  // metres, at 1 m spacing: slope 4/3
  const Map map_ = make_map(kSize, kSize, [](int row, int column) {
    return std::max(0.0, kHeight - kHeight / kFoot * std::hypot(row - kApex, column - kApex));
  });
};

TEST_F(Cone, TipOfTheShadowLiesAtHeightOverTangent) {
  for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
    const auto sun = ground_direction(azimuth);
    for (const double distance : {31.0, 50.0, 77.7, 110.0}) {
      const Receiver receiver{kApex + 0.5 - sun.east * distance, kApex + 0.5 + sun.north * distance, 0};
      EXPECT_NEAR(slope(map_, receiver, azimuth), kHeight / distance, 1e-12);
    }
  }
}

// The sampled cone strays from the true one by less than half a metre, and its shadow's edge by twice that at
// the most (tan E < 0.8): points within 1.5 m of the edge are left out.
TEST_F(Cone, EdgesOfTheShadowAreTheTangentsFromTheTip) {
  Random random(5);
  int shaded_points = 0;
  for (int i = 0; i < 40000; ++i) {
    const double elevation = uniform(random, 20, 38), azimuth = random_azimuth(random);
    const auto sun = ground_direction(azimuth);
    const double tip = kHeight / tangent(elevation);
    const double half_angle = std::asin(kFoot / tip);
    const double behind = uniform(random, -118, 118), aside = uniform(random, -80, 80);
    if (std::hypot(behind, aside) < kFoot + 1.5) continue;
    const Receiver receiver{kApex + 0.5 - behind * sun.east - aside * sun.north,
                            kApex + 0.5 + behind * sun.north - aside * sun.east, 0};
    if (std::min(receiver.column, receiver.row) < 0 || std::max(receiver.column, receiver.row) > kSize)
      continue;
    // Signed distance to the nearer tangent, positive within the wedge that opens from the tip towards the
    // cone.
    const double within = (tip - behind) * std::sin(half_angle) - std::abs(aside) * std::cos(half_angle);
    if (std::abs(within) < 1.5) continue;
    const bool expected =
        within > 0 && behind > kFoot * std::sin(half_angle);  // behind the points of contact
    shaded_points += expected;
    EXPECT_EQ(shaded(map_, receiver, azimuth, elevation), expected)
        << behind << " " << aside << " " << elevation;
  }
  EXPECT_GT(shaded_points, 500);
}

TEST_F(Cone, CastsBeyondItsFootOnlyBelowItsSlope) {
  const Receiver behind{kApex + 0.5 - kFoot - 0.01, kApex + 0.5, 0};
  const double elevation = std::atan(kHeight / kFoot) * 180 / std::numbers::pi;
  EXPECT_TRUE(shaded(map_, behind, 90, elevation - 0.1));
  EXPECT_FALSE(shaded(map_, behind, 90, elevation + 0.1));
}

class Crater : public testing::Test {
 protected:
  static constexpr int kSize = 201, kCentre = 100;
  static constexpr double kRadius = 80,
                          kCurvature = 1.0 / 256;  // z = c (r^2 - a^2): whole 256ths, exact in float
  const Map map_ = make_map(kSize, kSize, [](int row, int column) {
    const double x = column - kCentre, y = row - kCentre;
    return std::min(0.0, kCurvature * (x * x + y * y - kRadius * kRadius));
  });
};

TEST_F(Crater, HorizonInsideIsTheSunwardRim) {
  for (int column = kCentre - 80; column < kCentre + 80; ++column) {
    EXPECT_DOUBLE_EQ(slope(map_, on_sample(kCentre, column), 90), kCurvature * (column - kCentre + kRadius));
  }
}

// Towards the sun at +x the horizon of (x, y) is c (x + X) with the rim at X = sqrt(a^2 - y^2), so shadow
// begins at the far rim shifted by tan E / c. Between samples the bowl is too high by up to c/2 and the rim
// off by up to its slope 2 c a times a patch's diagonal, both seen from the distance X - x.
TEST_F(Crater, ShadowBeginsAtTheFarRimShiftedTowardsTheSun) {
  Random random(6);
  const double error = kCurvature / 2 + 2 * kCurvature * kRadius * std::numbers::sqrt2;
  int shaded_points = 0;
  for (int i = 0; i < 20000; ++i) {
    const double azimuth = random_azimuth(random), elevation = uniform(random, 5, 35);
    const auto sun = ground_direction(azimuth);
    const double x = uniform(random, -78, 78), y = uniform(random, -78, 78);
    const double rim = std::sqrt(std::max(0.0, kRadius * kRadius - y * y));
    if (std::hypot(x, y) > kRadius - 2) continue;
    const Receiver receiver{kCentre + 0.5 + x * sun.east + y * sun.north,
                            kCentre + 0.5 - x * sun.north + y * sun.east, 0};
    EXPECT_NEAR(slope(map_, receiver, azimuth), kCurvature * (x + rim), error / (rim - x)) << x << " " << y;
    const double boundary = -rim + tangent(elevation) / kCurvature;
    if (std::abs(x - boundary) < error / (rim - x) / kCurvature) continue;
    shaded_points += x > boundary;
    EXPECT_EQ(shaded(map_, receiver, azimuth, elevation), x > boundary);
  }
  EXPECT_GT(shaded_points, 1000);
}

TEST(Saddle, HorizonInsideOnePatchSeenFromAbove) {
  // h = 2 K f (1 - f) along the diagonal; from e above its foot the line of sight touches at f = sqrt(e /
  // 2K).
  const auto map = make_map(2, 2, [](int row, int column) { return row == column ? 0 : 4; });
  EXPECT_DOUBLE_EQ(slope(map, {0.5, 0.5, 0.5}, 135), (8 - 4) / std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(slope(map, {1.5, 0.5, 0}, 225), 0)
      << "the valley's own axis sinks first, and the far rim is level";
}

TEST(Saddle, HorizonInsideTheNextPatchSeenFromTheGround) {
  // A flat patch, then h = 2 K f (1 - f): (h / d)' = 0 at f = sqrt(2) - 1.
  const auto map = make_map(3, 3, [](int row, int column) { return row + column == 3 ? 5 : 0; });
  const double expected = std::numbers::sqrt2 * 5 * (3 - 2 * std::numbers::sqrt2);
  EXPECT_NEAR(slope(map, on_sample(0, 0), 135), expected, 1e-14);
}

TEST(Saddle, TheLimitAtTheReceiverCounts) {
  // From the foot of the same saddle the ground is steepest at once: h / d tends to 2 K / sqrt(2).
  const auto map = make_map(2, 2, [](int row, int column) { return row == column ? 0 : 4; });
  EXPECT_DOUBLE_EQ(slope(map, {0.5, 0.5, 0}, 135), 8 / std::numbers::sqrt2);
  EXPECT_DOUBLE_EQ(slope(map, {1.5, 1.5, 0}, 315), 8 / std::numbers::sqrt2);
}

TEST(PatchEdges, AlongRowsAndColumnsTheSteepestSampleAheadIsTheHorizon) {
  Random random(7);
  auto map = noise_map(random, 23, 17, 50);
  map.spacing_x = 3;
  map.spacing_y = 0.7;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      for (int quarter = 0; quarter < 4; ++quarter) {
        const int step_x = quarter == 1   ? 1
                           : quarter == 3 ? -1
                                          : 0,
                  step_y = quarter == 2   ? 1
                           : quarter == 0 ? -1
                                          : 0;
        const double spacing = step_x != 0 ? map.spacing_x : map.spacing_y;
        double expected = -std::numeric_limits<double>::infinity();
        int x = column + step_x, y = row + step_y, steps = 1;
        for (; x >= 0 && x < map.width && y >= 0 && y < map.height; x += step_x, y += step_y, ++steps) {
          expected = std::max(expected, (double(map.at(y, x)) - map.at(row, column)) / (steps * spacing));
        }
        // Beyond the last sample the surface runs on level for half a spacing.
        const double last = double(map.at(y - step_y, x - step_x)) - map.at(row, column);
        expected = std::max(expected, last / ((steps - 0.5) * spacing));
        EXPECT_NEAR(slope(map, on_sample(row, column), 90.0 * quarter), expected, 1e-13);
      }
    }
  }
}

TEST(PatchEdges, JustAheadOfTheReceiverCostNoDigits) {
  // A ray past a corner crosses two edges within a hair's breadth: up a slope of 0.6 eastward, up one of 40,
  // then down again. The second edge is the horizon.
  const auto map = make_map(3, 3, [](int row, int column) {
    constexpr double kHeights[3][3] = {
        {4000.1, 4000.7, 4040.7}, {4000.1, 4000.7, 4040.7}, {3900.1, 3900.7, 3940.7}};
    return kHeights[row][column];
  });
  const double slope_before = double(map.at(1, 1)) - map.at(1, 0);
  const double slope_after = double(map.at(1, 2)) - map.at(1, 1);
  for (int i = 1; i < 100; ++i) {
    const double gap = i * 1e-11;
    const Receiver receiver{1.5 - gap, 1.5 - 1.5 * gap, 0};
    const double before = (1.5 - receiver.column) / 0.8, after = (1.5 - receiver.row) / 0.6 - before;
    const double expected = 0.8 * (slope_before * before + slope_after * after) / (before + after);
    EXPECT_NEAR(horizon_slope(map.surface(), receiver, {0.8, -0.6}), expected, 1e-12) << gap;
  }
}

}  // namespace
}  // namespace gnomon::oracle
