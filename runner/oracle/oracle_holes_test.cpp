// SPDX-License-Identifier: MIT
// The oracle on maps with holes: against dense sampling of the surface that is there, and against what holes
// are for.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/oracle.h"
#include "oracle/test_maps.h"

namespace gnomon::oracle {
namespace {

using namespace test;

constexpr float kHole = -1e30F;

/// By the definition: a patch that holds the place, edges included, has four samples.
bool naive_surface(const Map& map, double column, double row) {
  const auto whole = [&](int patch_column, int patch_row) {
    for (const int j : {patch_column - 1, patch_column})
      for (const int i : {patch_row - 1, patch_row})
        if (map.at(std::clamp(i, 0, map.height - 1), std::clamp(j, 0, map.width - 1)) == kHole) return false;
    return true;
  };
  for (int i = 0; i <= map.height; ++i)
    for (int j = 0; j <= map.width; ++j) {
      const bool holds = column >= j - 0.5 && column <= j + 0.5 && row >= i - 0.5 && row <= i + 0.5;
      if (holds && whole(j, i)) return true;
    }
  return false;
}

/// Smooth enough that a fine sampling misses little; holes of one sample and of several.
Map pierced(Random& random, double share) {
  Map map = smooth_map(random, 21, 17);
  for (int i = 0; i < map.height; ++i)
    for (int j = 0; j < map.width; ++j)
      if (uniform(random, 0, 1) < share) map.samples[static_cast<std::size_t>(i * map.width + j)] = kHole;
  return map;
}

TEST(HasSurface, IsThatOfTheDefinition) {
  Random random(21);
  const Map map = pierced(random, 0.2);
  for (double row = 0; row <= map.height; row += 0.125)
    for (double column = 0; column <= map.width; column += 0.125)
      ASSERT_EQ(has_surface(map.surface(), column, row), naive_surface(map, column, row))
          << column << ' ' << row;
}

TEST(Holes, DenseSamplingOfTheSurfaceBoundsTheHorizonFromBothSides) {
  Random random(22);
  int asked = 0;
  for (const double share : {0.02, 0.1, 0.3}) {
    const Map map = pierced(random, share);
    for (int i = 0; i < 120; ++i) {
      const auto receiver = random_receiver(random, map, i % 3 == 0 ? 0.5 : 0);
      if (!naive_surface(map, receiver.column, receiver.row)) continue;
      // Diagonals through corners are sampled beside them as often as on them; they have tests of their own.
      const double azimuth = i % 3 == 1 ? 90.0 * uniform_int(random, 0, 3) : uniform(random, 0, 360);
      const auto sun = ground_direction(azimuth);
      const double exact = horizon_slope(map.surface(), receiver, sun);
      const double eye =
          static_cast<double>(naive_height(map, receiver.column, receiver.row)) + receiver.height;
      double sampled = -std::numeric_limits<double>::infinity();
      constexpr double kStep = 2e-4;
      for (double distance = 1e-5; distance < 40;
           distance = distance < 0.5 ? distance * 1.001 : distance + kStep) {
        const double column = receiver.column + distance * sun.east;
        const double row = receiver.row - distance * sun.north;
        if (column < 0 || column > map.width || row < 0 || row > map.height) break;
        if (!naive_surface(map, column, row)) continue;
        sampled = std::max(sampled, (static_cast<double>(naive_height(map, column, row)) - eye) / distance);
      }
      const double steepest = std::sqrt(2.0) * steepest_slope(map.surface());
      const double missed = 4 * steepest * 1e-3 + 0.5 * 1e-3;
      ASSERT_GE(exact, sampled - 1e-7) << receiver.column << ' ' << receiver.row << " towards " << azimuth;
      // A strip of surface that is thinner than a step can be missed; it ends in samples, which are not.
      ASSERT_LE(exact, std::max(sampled + missed, -1e30))
          << receiver.column << ' ' << receiver.row << " towards " << azimuth;
      ++asked;
    }
  }
  EXPECT_GT(asked, 100);
}

/// Level ground at 10 m, a wall of 5 m in column 12, holes where the test wants them.
class HolesAndAWall : public testing::Test {
 protected:
  void hole(int row, int column) {
    map_.samples[static_cast<std::size_t>(row * map_.width + column)] = kHole;
  }
  [[nodiscard]] double towards_east(double column, double row) const {
    return horizon_slope(map_.surface(), {column, row, 0}, ground_direction(90));
  }
  Map map_ = make_map(20, 9, [](int, int column) { return column == 12 ? 15 : 10; });
};

TEST_F(HolesAndAWall, AHoleOnTheWayChangesNothing) {
  const double before = towards_east(2.5, 4.5);
  EXPECT_DOUBLE_EQ(before, 0.5);
  for (const int column : {6, 7, 8}) hole(4, column);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 4.5), before);
}

TEST_F(HolesAndAWall, AHoleInTheWallLetsTheSunThrough) {
  hole(4, 12);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 4.2), 0);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 5.4), 0);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 5.5), 0.5) << "the edge of the hole belongs to the patches beyond it";
  EXPECT_DOUBLE_EQ(towards_east(2.5, 3.5), 0.5);
}

TEST_F(HolesAndAWall, TheFarRimOfAHoleIsSeen) {
  // The hole takes the wall's western flank; its crest is the rim.
  for (int row = 0; row < 9; ++row) hole(row, 11);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 4.5), 0.5);
  EXPECT_DOUBLE_EQ(towards_east(9.5, 4.3), 5.0 / 3);
}

TEST_F(HolesAndAWall, WithoutGroundOrAnythingAheadThereIsNoHorizon) {
  hole(4, 2);
  EXPECT_EQ(towards_east(2.5, 4.5), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(towards_east(2.2, 4.1), -std::numeric_limits<double>::infinity());
  for (int row = 0; row < 9; ++row)
    for (int column = 4; column < 20; ++column) hole(row, column);
  EXPECT_EQ(towards_east(3.5, 7.5), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(horizons(map_.surface(), std::vector<Receiver>{{3.5, 7.5, 0}}, ground_direction(90), 1)[0],
            -std::acos(-1.0) / 2);
}

TEST_F(HolesAndAWall, ARayAlongTheEdgeOfAHoleSeesIt) {
  // Everything south of row 4 is missing: the ray along row 4 has patches on its north only.
  for (int row = 5; row < 9; ++row)
    for (int column = 0; column < 20; ++column) hole(row, column);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 4.5), 0.5);
  // And everything north of it, further on, but for the patches around the wall's crest.
  hole(3, 6);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 4.5), 0.5);
  hole(3, 12);
  EXPECT_DOUBLE_EQ(towards_east(2.5, 4.5), 0);
}

TEST(ManyHoles, PassingOverBlocksNeverChangesTheHorizon) {
  Random random(23);
  Map map = make_map(150, 97, [&](int row, int column) {
    return 40 * std::sin(0.05 * column) * std::cos(0.06 * row) + uniform(random, 0, 3);
  });
  for (float& sample : map.samples)
    if (uniform(random, 0, 1) < 0.05) sample = kHole;
  for (int row = 40; row < 80; ++row)
    for (int column = 30; column < 80; ++column)
      map.samples[static_cast<std::size_t>(row * 150 + column)] = kHole;
  std::vector<Receiver> receivers;
  for (int i = 0; i < 3000; ++i) receivers.push_back(random_receiver(random, map, i % 4 == 0 ? 25 : 0));
  for (const double azimuth : {0.0, 45.0, 90.0, 180.0, 200.0, 270.0, 77.7}) {
    const auto sun = ground_direction(azimuth);
    const auto angles = horizons(map.surface(), receivers, sun, 1);
    for (std::size_t i = 0; i < receivers.size(); ++i)
      ASSERT_NEAR(angles[i], std::atan(horizon_slope(map.surface(), receivers[i], sun)), 1e-12) << azimuth;
  }
}

}  // namespace
}  // namespace gnomon::oracle
