// SPDX-License-Identifier: MIT
// View rays as C++, against the oracle's rays in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "oracle/view_ray.h"
#include "technique/surface.h"
#include "terrain/procedural.h"
#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(8, 8));  // 5 m high, 1 m apart

Modules::GnomonHit look(const MapModules& modules, vec3 origin, vec3 direction) {
  return modules.gnomon_relief_view(modules.map(), origin, direction, 0, modules.step_limit());
}

TEST(CutSpan, KeepsWhatLiesBetweenAndNothingOfARayBesideIt) {
  const Modules::GnomonSpan all{0, GNOMON_NEVER};
  const auto span = kFlat.gnomon_cut_span(all, -2, 0.5F, 0, 8);
  EXPECT_EQ(span.first, 4);
  EXPECT_EQ(span.last, 20);
  const auto back = kFlat.gnomon_cut_span(all, 9, -1, 0, 8);
  EXPECT_EQ(back.first, 1);
  EXPECT_EQ(back.last, 9);
  const auto beside = kFlat.gnomon_cut_span(all, 9, 0, 0, 8);
  EXPECT_GT(beside.first, beside.last);
}

TEST(Hit, HoldsWhatItIsGiven) {
  const auto hit = kFlat.gnomon_hit(vec2(1, 2), 3, 4, GNOMON_VIEW_SKY);
  EXPECT_EQ(hit.at, vec2(1, 2));
  EXPECT_EQ(hit.depth, 3);
  EXPECT_EQ(hit.steps, 4);
  EXPECT_EQ(hit.cause, GNOMON_VIEW_SKY);
}

TEST(DiveRoot, IsTheRootAtWhichTheClearanceGrows) {
  // -3 + 2 s + s^2 = (s + 3)(s - 1)
  EXPECT_FLOAT_EQ(kFlat.gnomon_dive_root({.slope = 2, .curvature = 1, .above = 0}, -3, 4), 1);
  // -3 + 4 s - s^2 = -(s - 1)(s - 3)
  EXPECT_FLOAT_EQ(kFlat.gnomon_dive_root({.slope = 4, .curvature = -1, .above = 0}, -3, 2), 1);
}

TEST(Dive, ClosesTheGapOfRoundingButIsNotSeenFromBelow) {
  const Modules::GnomonCrossing rising{.slope = 1, .curvature = 0, .above = 0};
  EXPECT_EQ(kFlat.gnomon_dive(rising, 1e-6F, 1, true), 0) << "it was above when it left the patch before";
  EXPECT_EQ(kFlat.gnomon_dive(rising, 1e-6F, 1, false), GNOMON_NEVER);
  EXPECT_FLOAT_EQ(kFlat.gnomon_dive(rising, -0.25F, 1, true), 0.25F);
  EXPECT_EQ(kFlat.gnomon_dive(rising, -2, 1, true), GNOMON_NEVER);
  // 2 - 3 s + s^2 = (s - 1)(s - 2): up through the surface at 1, under it again at 2.
  EXPECT_FLOAT_EQ(kFlat.gnomon_dive({.slope = -3, .curvature = 1, .above = 0}, 2, 3, false), 2);
  EXPECT_EQ(kFlat.gnomon_dive({.slope = -3, .curvature = 1, .above = 0}, 2, 1.5F, false), GNOMON_NEVER);
}

TEST(ReliefView, SeesAFlatMapWhereItStands) {
  const auto down = look(kFlat, vec3(3.25F, 6, 9), vec3(0, 0, -2));
  EXPECT_EQ(down.cause, GNOMON_VIEW_SURFACE);
  EXPECT_EQ(down.at, vec2(3.25F, 2)) << "row 0 lies in the north";
  EXPECT_EQ(down.depth, 2) << "in lengths of the direction";
  const auto slanted = look(kFlat, vec3(-1, 4, 8), vec3(1, 0, -0.5F));
  EXPECT_EQ(slanted.cause, GNOMON_VIEW_SURFACE);
  EXPECT_FLOAT_EQ(slanted.at.x, 5);
  EXPECT_FLOAT_EQ(slanted.depth, 6);
}

TEST(ReliefView, SeesNoGroundAboveBesideAndFromBelow) {
  for (const auto& [origin, direction] : {std::pair{vec3(3, 3, 9), vec3(0, 0, 1)},
                                          {vec3(3, 3, 9), vec3(1, 0, 0.1F)},
                                          {vec3(-9, 3, 9), vec3(-1, 0, -1)},
                                          {vec3(-9, 3, 6), vec3(1, 5, -0.1F)},
                                          {vec3(3, 3, 1), vec3(1, 0, 0.5F)},
                                          {vec3(3, 3, 1), vec3(0, 0, -1)}}) {
    const auto hit = look(kFlat, origin, direction);
    EXPECT_EQ(hit.cause, GNOMON_VIEW_SKY) << origin.x << " " << origin.z;
    EXPECT_EQ(hit.depth, 0);
  }
}

TEST(ViewWalk, StaysUndecidedAtItsStepLimitOnly) {
  // Under the flat ground no block can be passed over: 6 patches to the edge.
  auto ray = kFlat.gnomon_ray(kFlat.map(), kFlat.gnomon_receiver_at(2, 2, 0), vec3(1, 0, 0.01F), 0);
  ray.height = -1;
  EXPECT_EQ(kFlat.gnomon_view_walk(kFlat.map(), ray, false, 0, 2).cause, GNOMON_VIEW_UNDECIDED);
  EXPECT_EQ(kFlat.gnomon_view_walk(kFlat.map(), ray, false, 0, 100).cause, GNOMON_VIEW_SKY);
}

TEST(ViewWalk, BeginsUnderTheSurfaceOnlyWhereItIsTold) {
  auto ray = kFlat.gnomon_ray(kFlat.map(), kFlat.gnomon_receiver_at(2, 2, 0), vec3(1, 0, -0.5F), 0);
  ray.height = -0.001F;  // under the flat ground
  EXPECT_EQ(kFlat.gnomon_view_walk(kFlat.map(), ray, true, 0, 100).cause, GNOMON_VIEW_SURFACE);
  EXPECT_EQ(kFlat.gnomon_view_walk(kFlat.map(), ray, false, 0, 100).cause, GNOMON_VIEW_SKY);
}

TEST(ReliefView, AgreesWithDoublePrecisionOnRandomRays) {
  for (const char* kind : {"fractal", "gorge", "steps", "spikes"}) {
    const MapModules modules(
        terrain::make_procedural(
            {.kind = kind, .width = 133, .height = 70, .seed = 3, .spacing_x = 10, .spacing_y = 10})
            .value());
    const oracle::Surface surface = technique::surface_of(modules.heights());
    const oracle::ViewTracer tracer(surface);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> unit(0, 1);
    const float highest = modules.map().highest;
    int hits = 0;
    int far = 0;
    for (int i = 0; i < 20000; ++i) {
      const vec3 origin(1330 * (3 * unit(random) - 1), 700 * (3 * unit(random) - 1),
                        highest * (0.2F + 2 * unit(random)));
      const vec3 target(1330 * unit(random), 700 * unit(random), highest * unit(random));
      const vec3 direction = normalize(target - origin);
      const auto hit = look(modules, origin, direction);
      const auto expected =
          tracer.first_hit({{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}});
      ASSERT_NE(hit.cause, GNOMON_VIEW_UNDECIDED);
      hits += expected.has_value();
      const bool same = expected.has_value() == (hit.cause == GNOMON_VIEW_SURFACE) &&
                        std::abs(expected.value_or(0) - double{hit.depth}) <= 0.01 + 1e-5 * double{hit.depth};
      far += !same;
    }
    EXPECT_GT(hits, 3000) << kind;
    // Rays that graze an edge, which the last bits decide; the faces of steps are seen edge on.
    EXPECT_LT(far, 60) << kind;
  }
}

// Level ground 5 m high with a hole of 3 x 3 samples, a wall of 9 m behind it.
MapModules pierced() {
  terrain::HeightMap map = flat_map(20, 9);
  for (std::size_t row = 0; row < 9; ++row) map.samples[row * 20 + 15] = 9;
  for (std::size_t i = 0; i < 9; ++i) map.samples[(3 + i / 3) * 20 + 6 + i % 3] = GNOMON_NO_SAMPLE;
  return MapModules(map);
}

TEST(ReliefView, SeesThroughHoles) {
  const MapModules modules = pierced();
  // From above: the hole, its rim, which is ground, and the ground beside it.
  EXPECT_EQ(look(modules, vec3(7.5F, 4.5F, 20), vec3(0, 0, -1)).cause, GNOMON_VIEW_SKY);
  EXPECT_EQ(look(modules, vec3(5.6F, 4.5F, 20), vec3(0, 0, -1)).cause, GNOMON_VIEW_SKY);
  EXPECT_EQ(look(modules, vec3(5.5F, 4.5F, 20), vec3(0, 0, -1)).cause, GNOMON_VIEW_SURFACE);
  EXPECT_EQ(look(modules, vec3(9.5F, 4.5F, 20), vec3(0, 0, -1)).cause, GNOMON_VIEW_SURFACE);
  EXPECT_FLOAT_EQ(look(modules, vec3(4, 4, 20), vec3(0, 0, -1)).depth, 15);
  // Across the hole, and down on the ground behind it or on the wall.
  const auto wall = look(modules, vec3(2, 4.6F, 8), vec3(1, 0, 0));
  EXPECT_EQ(wall.cause, GNOMON_VIEW_SURFACE);
  EXPECT_NEAR(wall.at.x, 15.25F, 1e-5F);
  EXPECT_NEAR(look(modules, vec3(2, 4.6F, 8), vec3(1, 0, -0.375F)).at.x, 10, 1e-4F);
  // Into the hole: the ground behind it begins above the ray, which sees its underside and goes on below.
  EXPECT_EQ(look(modules, vec3(2, 4.6F, 8), vec3(1, 0, -0.6F)).cause, GNOMON_VIEW_SKY);
  // Out of the hole from below, over the ground, and down again behind the wall's foot.
  const auto from_below = look(modules, vec3(7.5F, 4.6F, 4.9F), vec3(1, 0, 0.2F));
  EXPECT_EQ(from_below.cause, GNOMON_VIEW_SURFACE);
  EXPECT_GT(from_below.at.x, 14);
}

TEST(ReliefView, AgreesWithTheOracleOverHoles) {
  terrain::HeightMap map =
      terrain::make_procedural(
          {.kind = "fractal", .width = 133, .height = 70, .seed = 8, .spacing_x = 10, .spacing_y = 10})
          .value();
  std::mt19937 random(6);
  for (float& sample : map.samples)
    if (random() % 25 == 0) sample = GNOMON_NO_SAMPLE;
  for (std::size_t i = 0; i < 900; ++i) map.samples[(20 + i / 30) * 133 + 50 + i % 30] = GNOMON_NO_SAMPLE;
  map.holes = true;
  const MapModules modules(map);
  const oracle::Surface surface = technique::surface_of(modules.heights());
  const oracle::ViewTracer tracer(surface);
  std::uniform_real_distribution<float> unit(0, 1);
  const float highest = modules.map().highest;
  int hits = 0, far = 0;
  for (int i = 0; i < 20000; ++i) {
    const vec3 origin(1330 * (3 * unit(random) - 1), 700 * (3 * unit(random) - 1),
                      highest * (0.2F + 2 * unit(random)));
    const vec3 target(1330 * unit(random), 700 * unit(random), highest * unit(random));
    const vec3 direction = i % 10 == 0 ? vec3(0, 0, -1) : normalize(target - origin);
    const vec3 from = i % 10 == 0 ? vec3(target.x, target.y, 2 * highest) : origin;
    const auto hit = look(modules, from, direction);
    const auto expected =
        tracer.first_hit({{from.x, from.y, from.z}, {direction.x, direction.y, direction.z}});
    ASSERT_NE(hit.cause, GNOMON_VIEW_UNDECIDED);
    hits += expected.has_value();
    const bool same = expected.has_value() == (hit.cause == GNOMON_VIEW_SURFACE) &&
                      std::abs(expected.value_or(0) - double{hit.depth}) <= 0.01 + 1e-5 * double{hit.depth};
    far += !same;
  }
  EXPECT_GT(hits, 3000);
  EXPECT_LT(far, 60);
}

}  // namespace
}  // namespace gnomon::modules
