// SPDX-License-Identifier: MIT
#include "judge/judge.h"

#include <gtest/gtest.h>

#include "judge/test_image.h"

namespace gnomon::judge {
namespace {

using scene::Expectation;
using scene::GoldenExpectation;
using scene::MaxStepsExpectation;
using scene::ProbeExpectation;
using scene::ReferenceExpectation;
using testing::add_channel;
using testing::flip_shadow;
using testing::golden_of;
using testing::set;
using testing::shadow_image;

Verdict judge_one(const Expectation& expectation, const Evidence& evidence) {
  const std::vector<Verdict> verdicts = judge({expectation}, evidence);
  EXPECT_EQ(verdicts.size(), 1U);
  return verdicts.at(0);
}

/// What the oracle gives: its shadow, its band and its horizon, without steps and validity.
image::Image reference_of(const image::Image& image) {
  image::Image reference{.width = image.width, .height = image.height, .channels = {}, .attributes = {}};
  reference.channels["b_shadow"] = image.channels.at("b_shadow");
  add_channel(reference, "band", 0);
  add_channel(reference, "horizon", 0.5F);
  return reference;
}

TEST(Judge, GivesOneVerdictForEachExpectationInOrder) {
  const image::Image actual = shadow_image(8, 8);
  const image::Image golden = golden_of(actual);
  const image::Image reference = reference_of(actual);
  const std::vector<Verdict> verdicts = judge(
      {GoldenExpectation{}, ReferenceExpectation{}, ReferenceExpectation{.level = 2},
       ProbeExpectation{.x = 1, .y = 2, .values = {{"b_shadow", 1}}}, MaxStepsExpectation{.limit = 400}},
      {.actual = actual,
       .golden = &golden,
       .reference = &reference,
       .reference_at_level = {{2, &reference}}});
  ASSERT_EQ(verdicts.size(), 5U);
  const char* names[] = {"golden", "reference", "reference at level 2", "probe (1, 2)", "max_steps 400"};
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_TRUE(verdicts[i].passed);
    EXPECT_EQ(verdicts[i].expectation, names[i]);
    EXPECT_FALSE(verdicts[i].measured.empty());
    EXPECT_FALSE(verdicts[i].limit.empty());
  }
}

TEST(Judge, AValueThatIsNotFiniteFailsEveryExpectation) {
  image::Image actual = shadow_image(8, 8);
  const image::Image golden = golden_of(actual);
  const image::Image reference = reference_of(actual);
  set(actual, "b_shadow", 3, 4, testing::kNan);
  const std::vector<Verdict> verdicts =
      judge({GoldenExpectation{.max_mismatch = 1}, ReferenceExpectation{.max_mismatch = 1},
             ProbeExpectation{.x = 0, .y = 0, .values = {{"valid", 1}}}, MaxStepsExpectation{.limit = 400}},
            {.actual = actual, .golden = &golden, .reference = &reference});
  ASSERT_EQ(verdicts.size(), 4U);
  for (const Verdict& verdict : verdicts) {
    EXPECT_FALSE(verdict.passed) << verdict.expectation;
    EXPECT_EQ(verdict.measured, "b_shadow is not finite at (3, 4)");
  }
}

TEST(Judge, AMissingGoldenFailsAndSaysSo) {
  const image::Image actual = shadow_image(2, 2);
  const Verdict verdict = judge_one(GoldenExpectation{.max_mismatch = 1}, {.actual = actual});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.measured, "no golden yet");
}

TEST(Judge, TheGoldensOptionsAreHeeded) {
  const image::Image actual = shadow_image(10, 10);
  image::Image golden = golden_of(actual);
  flip_shadow(golden, 1, 1);
  flip_shadow(golden, 2, 1);
  set(golden, "band", 1, 1, 1);
  const Evidence evidence{.actual = actual, .golden = &golden};
  EXPECT_FALSE(judge_one(GoldenExpectation{}, evidence).passed);
  EXPECT_TRUE(judge_one(GoldenExpectation{.max_mismatch = 0.011}, evidence).passed);
  EXPECT_FALSE(judge_one(GoldenExpectation{.max_mismatch = 0.011, .band = false}, evidence).passed);
  EXPECT_TRUE(judge_one(GoldenExpectation{.tolerance = {{"b_shadow", 1}}}, evidence).passed);
}

TEST(Judge, OnlyTheShadowIsHeldAgainstTheReference) {
  const image::Image actual = shadow_image(10, 10);
  image::Image reference = reference_of(actual);
  add_channel(reference, "k_shadow", 0.123F);
  EXPECT_TRUE(judge_one(ReferenceExpectation{}, {.actual = actual, .reference = &reference}).passed);
  flip_shadow(reference, 4, 7);
  const Verdict verdict = judge_one(ReferenceExpectation{}, {.actual = actual, .reference = &reference});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.mismatches, 1);
  EXPECT_EQ(verdict.worst->x, 4);
  EXPECT_EQ(verdict.worst->y, 7);
  EXPECT_EQ(verdict.worst->channel, "b_shadow");
}

TEST(Judge, TheReferencesBandExcusesWhatItMasks) {
  const image::Image actual = shadow_image(10, 10);
  image::Image reference = reference_of(actual);
  flip_shadow(reference, 4, 7);
  set(reference, "band", 4, 7, 1);
  const Verdict verdict = judge_one(ReferenceExpectation{}, {.actual = actual, .reference = &reference});
  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.in_band, 1);
  EXPECT_EQ(verdict.compared, 99);
}

TEST(Judge, TheReferencesValidityMustBeMetWhereItSaysOne) {
  image::Image actual = shadow_image(4, 4);
  image::Image reference = reference_of(actual);
  set(actual, "valid", 0, 0, 0);
  EXPECT_TRUE(judge_one(ReferenceExpectation{}, {.actual = actual, .reference = &reference}).passed);
  add_channel(reference, "valid", 1);
  EXPECT_EQ(judge_one(ReferenceExpectation{}, {.actual = actual, .reference = &reference}).mismatches, 1);
}

TEST(Judge, AKnownMismatchMustLieBetweenItsLimits) {
  const image::Image actual = shadow_image(10, 10);
  image::Image reference = reference_of(actual);
  const Evidence evidence{.actual = actual, .reference = &reference};
  const ReferenceExpectation known{.mismatch = {{0.02, 0.03}}};
  const bool passes[] = {false, false, true, true, false};  // with 0, 1, ... pixels of 100 wrong
  for (int wrong = 0; wrong < 5; ++wrong) {
    if (wrong > 0) flip_shadow(reference, wrong, wrong);
    EXPECT_EQ(judge_one(known, evidence).passed, passes[wrong]) << wrong;
  }
  EXPECT_EQ(judge_one(known, evidence).limit, "from 2 % to 3 %");
}

TEST(Judge, EachLevelIsHeldAgainstItsOwnReference) {
  const image::Image actual = shadow_image(4, 4);
  const image::Image same = reference_of(actual);
  image::Image other = same;
  flip_shadow(other, 0, 0);
  const Evidence evidence{.actual = actual, .reference = &same, .reference_at_level = {{0, &other}}};
  EXPECT_TRUE(judge_one(ReferenceExpectation{}, evidence).passed);
  EXPECT_FALSE(judge_one(ReferenceExpectation{.level = 0}, evidence).passed);
  EXPECT_FALSE(judge_one(ReferenceExpectation{.max_mismatch = 1, .level = 3}, evidence).passed) << "absent";
}

TEST(Judge, AMissingReferenceFails) {
  const image::Image actual = shadow_image(4, 4);
  EXPECT_FALSE(judge_one(ReferenceExpectation{.mismatch = {{0, 1}}}, {.actual = actual}).passed);
}

TEST(Judge, AProbeIsNotExcusedByTheBand) {
  const image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  add_channel(golden, "band", 1);
  const Verdict verdict = judge_one(ProbeExpectation{.x = 1, .y = 2, .values = {{"b_shadow", 0}}},
                                    {.actual = actual, .golden = &golden, .reference = &golden});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.measured, "b_shadow is 1");
  EXPECT_EQ(verdict.limit, "b_shadow is 0");
  EXPECT_EQ(verdict.worst->actual, 1);
  EXPECT_EQ(verdict.worst->expected, 0);
}

TEST(Judge, AProbeIsExactForFlagsAndLevelsAndNearlySoElsewhere) {
  image::Image actual = shadow_image(2, 2);
  const auto probe = [&](const char* channel, float stored, double value) {
    set(actual, channel, 0, 1, stored);
    return judge_one(ProbeExpectation{.x = 0, .y = 1, .values = {{channel, value}}}, {.actual = actual})
        .passed;
  };
  EXPECT_TRUE(probe("k_shadow", 0.4F, 0.4 + 9e-7));
  EXPECT_FALSE(probe("k_shadow", 0.4F, 0.4 + 1.2e-6));
  EXPECT_TRUE(probe("q", 2.0F, 2));
  EXPECT_FALSE(probe("q", 2.0F, 2 + 9e-7));
  EXPECT_FALSE(probe("b_shadow", 1.0F, 1 - 5e-7));
  EXPECT_FALSE(probe("valid", 1.0F, 0));
}

TEST(Judge, AProbeAsksForNoMorePrecisionThanAnImageHolds) {
  image::Image actual = shadow_image(2, 2);
  add_channel(actual, "depth", 1234.567F);  // 5e-5 away from the decimal
  const Evidence evidence{.actual = actual};
  EXPECT_TRUE(judge_one(ProbeExpectation{.values = {{"depth", 1234.567}}}, evidence).passed);
  EXPECT_FALSE(judge_one(ProbeExpectation{.values = {{"depth", 1234.568}}}, evidence).passed);
}

TEST(Judge, AProbeReportsItsWorstChannel) {
  const image::Image actual = shadow_image(2, 2);
  const Verdict verdict = judge_one(
      ProbeExpectation{.values = {{"b_shadow", 0}, {"k_shadow", 0.5}, {"q", 3}}}, {.actual = actual});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.worst->channel, "q");
  EXPECT_EQ(verdict.measured, "b_shadow is 0, k_shadow is 1, q is 0");
  EXPECT_EQ(verdict.limit, "b_shadow is 0, k_shadow is 0.5, q is 3");
}

TEST(Judge, AProbeOutsideTheImageFails) {
  const image::Image actual = shadow_image(4, 3);
  for (const auto& [x, y] : {std::pair{4, 0}, {0, 3}, {-1, 0}, {0, -1}}) {
    const Verdict verdict =
        judge_one(ProbeExpectation{.x = x, .y = y, .values = {{"b_shadow", 0}}}, {.actual = actual});
    EXPECT_FALSE(verdict.passed);
    EXPECT_NE(verdict.measured.find("outside the image"), std::string::npos);
  }
}

TEST(Judge, AProbeOfAChannelThatIsNotThereFails) {
  const image::Image actual = shadow_image(4, 3);
  const Verdict verdict = judge_one(ProbeExpectation{.values = {{"occlusion", 0}}}, {.actual = actual});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.limit, "channel occlusion");
}

TEST(Judge, NoPixelMayTakeMoreStepsThanTheLimit) {
  image::Image actual = shadow_image(8, 2);  // steps 0 ... 7
  const Evidence evidence{.actual = actual};
  const Verdict within = judge_one(MaxStepsExpectation{.limit = 7}, evidence);
  EXPECT_TRUE(within.passed);
  EXPECT_EQ(within.measured, "up to 7 steps, at (7, 0)");
  const Verdict verdict = judge_one(MaxStepsExpectation{.limit = 5}, evidence);
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.mismatches, 4);
  EXPECT_EQ(verdict.worst->x, 7);
  EXPECT_EQ(verdict.worst->y, 0);
  EXPECT_EQ(verdict.worst->actual, 7);
  EXPECT_EQ(verdict.worst->expected, 5);
  actual.channels.erase("steps");
  EXPECT_FALSE(judge_one(MaxStepsExpectation{.limit = 7}, evidence).passed);
}

TEST(Judge, AnEmptyImageFailsEverything) {
  const image::Image empty;
  image::Image hollow;
  add_channel(hollow, "steps", 0);
  for (const image::Image* actual : {&empty, static_cast<const image::Image*>(&hollow)}) {
    const std::vector<Verdict> verdicts =
        judge({GoldenExpectation{}, ReferenceExpectation{}, ProbeExpectation{.values = {{"q", 0}}},
               MaxStepsExpectation{.limit = 1}},
              {.actual = *actual, .golden = &empty, .reference = &empty});
    for (const Verdict& verdict : verdicts) EXPECT_FALSE(verdict.passed) << verdict.expectation;
  }
}

}  // namespace
}  // namespace gnomon::judge
