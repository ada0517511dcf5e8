// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kModules(flat_map(4, 4));

vec2 direction(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return {std::cos(angle), std::sin(angle)};
}

TEST(Transit, LeavesThroughTheSideAheadInEveryQuadrant) {
  const vec2 middle(10.5F, 20.5F);
  const ivec2 low(10, 20);
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, vec2(1, 0)).offset, ivec2(1, 0));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, vec2(-1, 0)).offset, ivec2(-1, 0));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, vec2(0, 1)).offset, ivec2(0, 1));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, vec2(0, -1)).offset, ivec2(0, -1));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, direction(10)).offset, ivec2(1, 0));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, direction(80)).offset, ivec2(0, 1));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, direction(100)).offset, ivec2(0, 1));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, direction(170)).offset, ivec2(-1, 0));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, direction(190)).offset, ivec2(-1, 0));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, direction(260)).offset, ivec2(0, -1));
  EXPECT_EQ(kModules.gnomon_transit(middle, low, 1, vec2(0.6F, 0.8F)).t, 0.5F / 0.8F);
}

TEST(Transit, CrossesBothAxesAtACorner) {
  const float diagonal = std::sqrt(0.5F);
  const auto transit = kModules.gnomon_transit(vec2(8.5F), ivec2(8), 8, vec2(diagonal, diagonal));
  EXPECT_EQ(transit.offset, ivec2(1, 1));
  EXPECT_EQ(transit.t, 7.5F / diagonal);
  EXPECT_EQ(kModules.gnomon_transit(vec2(8.5F), ivec2(8), 8, vec2(-diagonal, diagonal)).offset, ivec2(-1, 0));
}

TEST(Transit, TakesAComponentOfTheMachineErrorForNone) {
  const auto transit = kModules.gnomon_transit(vec2(3.25F, 5), ivec2(3, 5), 1, vec2(-1, 1e-8F));
  EXPECT_EQ(transit.offset, ivec2(-1, 0));
  EXPECT_EQ(transit.t, 0.25F);
}

// Erratum l: whoever asks has to look at t. The walk answers a sun at the zenith before it asks.
TEST(Transit, HasNoneWithoutADirection) {
  const auto transit = kModules.gnomon_transit(vec2(3.5F), ivec2(3), 1, vec2(0));
  EXPECT_EQ(transit.t, -1.0F);
  EXPECT_EQ(transit.offset, ivec2(0, 0));
}

TEST(TransitNext, StepsTheCrossedAxisAndHoldsTheOther) {
  const Modules::GnomonTransit east{.t = 1, .offset = ivec2(1, 0)};
  EXPECT_EQ(kModules.gnomon_transit_next(east, vec2(16, 11.7F), ivec2(9, 10), ivec2(8, 8), 8, vec2(1, 0.5F)),
            ivec2(16, 11));
  EXPECT_EQ(kModules.gnomon_transit_next(east, vec2(16, 16.01F), ivec2(9, 10), ivec2(8, 8), 8, vec2(1, 0.5F)),
            ivec2(16, 15))
      << "rounded out of the block";
  EXPECT_EQ(kModules.gnomon_transit_next(east, vec2(16, 9.9F), ivec2(9, 10), ivec2(8, 8), 8, vec2(1, 0.5F)),
            ivec2(16, 10))
      << "rounded behind the texel by which it came in";
  const Modules::GnomonTransit west{.t = 1, .offset = ivec2(-1, 0)};
  EXPECT_EQ(kModules.gnomon_transit_next(west, vec2(8, 10), ivec2(9, 10), ivec2(8, 8), 8, vec2(-1, -0.5F)),
            ivec2(7, 10));
}

// The papers' promise, which their own text does not keep for negative directions (erratum g): every step
// goes on, so that a track of any direction has left a map of n x n texels after at most 2 n steps.
TEST(TransitNext, EveryTrackLeavesTheMap) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(0, 256);
  for (int i = 0; i < 20000; ++i) {
    const vec2 u = i % 4 == 0 ? direction(45.0 * (i % 32) / 4) : direction(i * 0.7713);
    vec2 entry(place(random), place(random));
    if (i % 3 == 0) entry = floor(entry);
    ivec2 current(floor(entry));
    int steps = 0;
    while (current.x >= 0 && current.y >= 0 && current.x < 256 && current.y < 256) {
      const auto transit = kModules.gnomon_transit(entry, current, 1, u);
      entry += u * transit.t;
      const ivec2 next = kModules.gnomon_transit_next(transit, entry, current, current, 1, u);
      ASSERT_EQ(abs(next.x - current.x) + abs(next.y - current.y) > 0, true);
      ASSERT_LE(++steps, 512);
      current = next;
    }
  }
}

// The texels of a track are those that a dense walk along the same line visits: none is missed, none
// invented.
TEST(TransitNext, VisitsTheTexelsUnderTheTrack) {
  for (int i = 0; i < 200; ++i) {
    const double angle = 1.8 * i + 0.37;
    const vec2 u = direction(angle);
    const dvec2 exact(std::cos(angle * std::numbers::pi / 180), std::sin(angle * std::numbers::pi / 180));
    vec2 entry(100.3F, 120.6F);
    ivec2 current(100, 120);
    double travelled = 0;
    for (int step = 0; step < 60; ++step) {
      const auto transit = kModules.gnomon_transit(entry, current, 1, u);
      const dvec2 middle = dvec2(100.3F, 120.6F) + exact * (travelled + transit.t / 2);
      const ivec2 expected(floor(middle));
      if (transit.t > 0.05F) {
        EXPECT_EQ(current, expected) << angle << " degrees, step " << step;
      }
      travelled += transit.t;
      entry += u * transit.t;
      current = kModules.gnomon_transit_next(transit, entry, current, current, 1, u);
    }
  }
}

}  // namespace
}  // namespace gnomon::modules
