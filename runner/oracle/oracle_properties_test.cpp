// SPDX-License-Identifier: MIT
// The oracle against dense sampling, and against itself on maps that are turned, mirrored, lifted and
// stretched.
#include <gtest/gtest.h>

#include <cmath>

#include "oracle/oracle.h"
#include "oracle/test_maps.h"

namespace gnomon::oracle {
namespace {

using namespace test;

// The kinds of terrain that break different things, of odd and extreme sizes and unequal spacings.
std::vector<Map> terrains(Random& random) {
  std::vector<Map> maps = {noise_map(random, 19, 13, 30),  noise_map(random, 40, 3, 1000),
                           spike_map(random, 33, 25),      smooth_map(random, 37, 24),
                           noise_map(random, 1, 30, 5),    noise_map(random, 30, 1, 5),
                           whole_metre_map(random, 16, 17)};
  maps[1].spacing_x = 25;
  maps[1].spacing_y = 40;
  maps[3].spacing_y = 1.5;
  return maps;
}

struct Sampled {
  double slope = -std::numeric_limits<double>::infinity();  ///< steepest slope over the sampled points
  double step = 0;                                          ///< ratio - 1 of neighbouring distances
  double first = 0;                                         ///< distance of the first point
};

// Slopes to points whose distances grow by a factor 1 + step up to the end of the domain, which is one of
// them.
Sampled sample_densely(const Map& map, const Receiver& receiver, GroundDirection sun, double step) {
  const double rate_x = sun.east / map.spacing_x, rate_y = -sun.north / map.spacing_y;
  const auto exit = [](double from, double size, double rate) {
    return rate > 0   ? (size - from) / rate
           : rate < 0 ? -from / rate
                      : std::numeric_limits<double>::infinity();
  };
  const double end =
      std::min(exit(receiver.column, map.width, rate_x), exit(receiver.row, map.height, rate_y));
  Sampled result{.step = step, .first = std::min(1e-5 * std::min(map.spacing_x, map.spacing_y), end)};
  const long double eye = naive_height(map, receiver.column, receiver.row) + receiver.height;
  const auto look = [&](double distance) {
    const long double height =
        naive_height(map, static_cast<long double>(receiver.column) + distance * rate_x,
                     static_cast<long double>(receiver.row) + distance * rate_y);
    result.slope = std::max(result.slope, static_cast<double>((height - eye) / distance));
  };
  for (double distance = result.first; distance < end; distance *= 1 + step) look(distance);
  if (end > 0) look(end);
  return result;
}

// What the samples can miss. With L the steepest slope along any track, |(h/d)'| <= 2 L / d on the ground, so
// a factor 1 + step misses 2 L step; from above, the next sample out sees the receiver's own height at a
// kinder angle. Before the first sample the slope is A d + B with |A| at most the patch's twist.
double may_miss(const Map& map, const Sampled& sampled) {
  const double steepest = std::sqrt(2.0) * steepest_slope(map.surface());
  const double twist = 4 * steepest / std::min(map.spacing_x, map.spacing_y);
  return 2 * steepest * sampled.step + twist * sampled.first;
}

TEST(DenseSampling, BoundsTheHorizonFromBothSides) {
  Random random(11);
  for (const auto& map : terrains(random)) {
    const double noise = 1e-9 * (1 + steepest_slope(map.surface()));
    for (int i = 0; i < 150; ++i) {
      const double above[] = {0, 0, 0.01, 0.5, 50};
      const auto receiver = random_receiver(random, map, above[i % 5]);
      const double azimuth = random_azimuth(random);
      const auto sun = ground_direction(azimuth);
      const double exact = horizon_slope(map.surface(), receiver, sun);
      for (const double step : {1e-1, 1e-2, 1e-3}) {  // the window closes as the sampling gets finer
        const auto sampled = sample_densely(map, receiver, sun, step);
        ASSERT_GE(exact, sampled.slope - noise)
            << receiver.column << " " << receiver.row << " +" << receiver.height << " towards " << azimuth;
        ASSERT_LE(exact, sampled.slope + may_miss(map, sampled) + noise)
            << receiver.column << " " << receiver.row << " +" << receiver.height << " towards " << azimuth;
      }
    }
  }
}

TEST(DenseSampling, AlongDiagonalsThroughCorners) {
  Random random(12);
  const auto map = noise_map(random, 21, 21, 10);
  for (int i = 0; i < 300; ++i) {
    const auto receiver = on_sample(uniform_int(random, 0, 20), uniform_int(random, 0, 20));
    const auto sun = ground_direction(45 + 90 * (i % 4));
    const auto sampled = sample_densely(map, receiver, sun, 1e-3);
    const double exact = horizon_slope(map.surface(), receiver, sun);
    ASSERT_GE(exact, sampled.slope - 1e-8);
    ASSERT_LE(exact, sampled.slope + may_miss(map, sampled) + 1e-8);
  }
}

TEST(EyeHeight, LowersTheHorizonContinuouslyDownToTheGround) {
  Random random(13);
  const auto map = spike_map(random, 40, 40);
  for (int i = 0; i < 300; ++i) {
    auto receiver = random_receiver(random, map, 0);
    const auto sun = ground_direction(random_azimuth(random));
    const double on_ground = horizon_slope(map.surface(), receiver, sun);
    if (!std::isfinite(on_ground)) continue;
    double below = on_ground;
    for (const double height : {1e-9, 1e-3, 0.5, 20.0}) {
      receiver.height = height;
      const double slope = horizon_slope(map.surface(), receiver, sun);
      EXPECT_LE(slope, below + 1e-9);
      below = slope;
      // At the peak of a patch's slope the loss goes with the square root of the eye's height.
      if (height == 1e-9) {
        EXPECT_NEAR(slope, on_ground, 0.1);
      }
    }
  }
}

// How a test map, a receiver and a direction are carried over to a changed map.
struct Question {
  Map map;
  Receiver receiver;
  GroundDirection sun;
};

Question turned_clockwise(const Question& q) {
  auto map = make_map(q.map.height, q.map.width,
                      [&](int row, int column) { return q.map.at(q.map.height - 1 - column, row); });
  map.spacing_x = q.map.spacing_y;
  map.spacing_y = q.map.spacing_x;
  return {
      map, {q.map.height - q.receiver.row, q.receiver.column, q.receiver.height}, {q.sun.north, -q.sun.east}};
}

Question mirrored(const Question& q) {
  auto map = make_map(q.map.width, q.map.height,
                      [&](int row, int column) { return q.map.at(row, q.map.width - 1 - column); });
  map.spacing_x = q.map.spacing_x;
  map.spacing_y = q.map.spacing_y;
  return {
      map, {q.map.width - q.receiver.column, q.receiver.row, q.receiver.height}, {-q.sun.east, q.sun.north}};
}

Question transposed(const Question& q) {
  auto map = make_map(q.map.height, q.map.width, [&](int row, int column) { return q.map.at(column, row); });
  map.spacing_x = q.map.spacing_y;
  map.spacing_y = q.map.spacing_x;
  return {map, {q.receiver.row, q.receiver.column, q.receiver.height}, {-q.sun.north, -q.sun.east}};
}

Question with_heights(const Question& q, double factor, double offset) {
  auto result = q;
  for (float& sample : result.map.samples) sample = static_cast<float>(sample * factor + offset);
  result.receiver.height *= factor;
  return result;
}

double answer(const Question& q) {
  return horizon_slope(q.map.surface(), q.receiver, q.sun);
}

class Metamorphic : public testing::Test {
 protected:
  // Calls check(question, its answer) for many questions whose coordinates survive being mirrored exactly.
  template <typename Check>
  void for_each_question(const Check& check) {
    Random random(14);
    for (auto map : terrains(random)) {
      for (int i = 0; i < 200; ++i) {
        const Receiver receiver{uniform_int(random, 0, 16 * map.width) / 16.0,
                                uniform_int(random, 0, 16 * map.height) / 16.0, i % 3 == 0 ? 0.75 : 0.0};
        const Question question{map, receiver, ground_direction(random_azimuth(random))};
        check(question, answer(question));
      }
    }
  }
};

void expect_same(double actual, double expected) {
  if (std::isinf(expected)) {
    EXPECT_EQ(actual, expected);
  } else {
    EXPECT_NEAR(actual, expected, 1e-12 * (1 + std::abs(expected)));
  }
}

TEST_F(Metamorphic, TurningMapAndSunTogetherChangesNothing) {
  for_each_question([](const Question& question, double expected) {
    auto turned = question;
    for (int turn = 0; turn < 3; ++turn) expect_same(answer(turned = turned_clockwise(turned)), expected);
    EXPECT_EQ(answer(turned_clockwise(turned)), expected) << "the fourth quarter turn is the same question";
  });
}

TEST_F(Metamorphic, MirroringChangesNothing) {
  for_each_question(
      [](const Question& question, double expected) { expect_same(answer(mirrored(question)), expected); });
}

TEST_F(Metamorphic, TransposingChangesNothing) {
  for_each_question(
      [](const Question& question, double expected) { expect_same(answer(transposed(question)), expected); });
}

TEST_F(Metamorphic, ScalingHeightsByAPowerOfTwoScalesTheSlopeExactly) {
  for_each_question([](const Question& question, double expected) {
    EXPECT_EQ(answer(with_heights(question, 8, 0)), 8 * expected);
    EXPECT_EQ(answer(with_heights(question, 0.25, 0)), 0.25 * expected);
  });
}

TEST_F(Metamorphic, LiftingTheWholeMapChangesNothing) {
  Random random(15);
  const auto map = whole_metre_map(random, 40, 31);  // whole metres stay exact when lifted
  for (int i = 0; i < 500; ++i) {
    const Question question{map, random_receiver(random, map, i % 2 * 0.5),
                            ground_direction(random_azimuth(random))};
    EXPECT_EQ(answer(with_heights(question, 1, 4000)), answer(question));
    EXPECT_EQ(answer(with_heights(question, 1, -100)), answer(question));
  }
}

// Many receivers on a map of several blocks, so that horizons() has terrain to pass over.
class ManyReceivers : public testing::Test {
 protected:
  ManyReceivers() {
    Random random(16);
    map_ = make_map(150, 97, [&](int row, int column) {
      return 40 * std::sin(0.05 * column) * std::cos(0.06 * row) + uniform(random, 0, 3);
    });
    for (int i = 0; i < 6000; ++i) receivers_.push_back(random_receiver(random, map_, i % 4 == 0 ? 25 : 0));
  }

  Map map_;
  std::vector<Receiver> receivers_;
};

TEST_F(ManyReceivers, PassingOverBlocksNeverChangesTheHorizon) {
  for (const double azimuth : {0.0, 45.0, 90.0, 135.0, 180.0, 200.0, 225.0, 270.0, 315.0, 359.0, 77.7}) {
    const auto sun = ground_direction(azimuth);
    const auto angles = horizons(map_.surface(), receivers_, sun, 1);
    ASSERT_EQ(angles.size(), receivers_.size());
    for (std::size_t i = 0; i < receivers_.size(); ++i) {
      ASSERT_NEAR(angles[i], std::atan(horizon_slope(map_.surface(), receivers_[i], sun)), 1e-12) << azimuth;
    }
  }
}

TEST_F(ManyReceivers, ThreadsDoNotChangeAnything) {
  const auto sun = ground_direction(123.4);
  const auto alone = horizons(map_.surface(), receivers_, sun, 1);
  EXPECT_EQ(horizons(map_.surface(), receivers_, sun, 3), alone);
  EXPECT_EQ(horizons(map_.surface(), receivers_, sun), alone);
}

TEST(Horizons, OfNobodyIsNothingAndOfTheEdgeIsStraightDown) {
  const auto map = make_map(1, 1, [](int, int) { return 3; });
  EXPECT_TRUE(horizons(map.surface(), {}, ground_direction(0)).empty());
  const Receiver edge[] = {{1, 0.5, 0}};
  EXPECT_EQ(horizons(map.surface(), edge, ground_direction(90)).at(0), std::atan(-HUGE_VAL));
}

}  // namespace
}  // namespace gnomon::oracle
