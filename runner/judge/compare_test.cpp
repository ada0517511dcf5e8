// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "judge/judge.h"
#include "judge/test_image.h"

namespace gnomon::judge {
namespace {

using testing::add_channel;
using testing::flip_shadow;
using testing::golden_of;
using testing::kInfinity;
using testing::kNan;
using testing::set;
using testing::shadow_image;

TEST(Compare, AnImagePassesAgainstItself) {
  const image::Image image = shadow_image(16, 9);
  const Verdict verdict = compare(image, golden_of(image), {});
  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.compared, 16 * 9);
  EXPECT_EQ(verdict.measured, "0 of 144 pixels differ");
  EXPECT_EQ(verdict.limit, "at most 0");
  EXPECT_FALSE(verdict.worst);
}

TEST(Compare, NineChangedPixelsAreCountedAsNine) {
  const image::Image actual = shadow_image(256, 256);
  image::Image golden = golden_of(actual);
  for (int i = 0; i < 9; ++i) flip_shadow(golden, 20 + 3 * i, 7 * i);
  const Verdict verdict = compare(actual, golden, {});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.mismatches, 9);
  EXPECT_EQ(verdict.measured, "9 of 65536 pixels differ (0.0137 %)");
}

TEST(Compare, APixelThatDiffersInSeveralChannelsCountsOnce) {
  const image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  flip_shadow(golden, 1, 2);
  set(golden, "k_shadow", 1, 2, 0.9F);
  set(golden, "q", 1, 2, 3);
  EXPECT_EQ(compare(actual, golden, {}).mismatches, 1);
}

TEST(Compare, TheBandExcusesExactlyThePixelsItMasks) {
  const image::Image actual = shadow_image(8, 8);
  image::Image golden = golden_of(actual);
  for (int x = 0; x < 8; ++x) flip_shadow(golden, x, 3);
  for (int x = 0; x < 5; ++x) set(golden, "band", x, 3, 1);
  set(golden, "band", 0, 0, 1);

  const Verdict verdict = compare(actual, golden, {});
  EXPECT_EQ(verdict.mismatches, 3);
  EXPECT_EQ(verdict.in_band, 6);
  EXPECT_EQ(verdict.compared, 64 - 6);
  EXPECT_EQ(verdict.worst->x, 5);

  const Verdict without_band = compare(actual, golden, {.band = false});
  EXPECT_EQ(without_band.mismatches, 8);
  EXPECT_EQ(without_band.in_band, 0);
  EXPECT_EQ(without_band.compared, 64);
}

TEST(Compare, AShareEqualToTheLimitPasses) {
  const image::Image actual = shadow_image(100, 100);
  image::Image golden = golden_of(actual);
  flip_shadow(golden, 50, 50);
  EXPECT_TRUE(compare(actual, golden, {.max_mismatch = 0.0001}).passed);
  EXPECT_FALSE(compare(actual, golden, {.max_mismatch = 0.000099}).passed);
}

TEST(Compare, ADifferenceEqualToTheToleranceIsNone) {
  const image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  set(golden, "k_shadow", 2, 1, 0.75F);  // actual: 0.4
  const double difference = double{0.75F} - double{0.4F};
  EXPECT_TRUE(compare(actual, golden, {.tolerance = {{"k_shadow", difference}}}).passed);
  EXPECT_FALSE(
      compare(actual, golden, {.tolerance = {{"k_shadow", std::nextafter(difference, 0.0)}}}).passed);
  EXPECT_FALSE(compare(actual, golden, {.tolerance = {{"b_shadow", 1}}}).passed);
}

TEST(Compare, TheDefaultToleranceIsForChannelsWithoutTheirOwn) {
  const image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  set(golden, "k_shadow", 2, 1, 0.5F);
  set(golden, "q", 2, 1, 0.125F);
  EXPECT_TRUE(compare(actual, golden, {.default_tolerance = 0.25}).passed);
  EXPECT_FALSE(compare(actual, golden, {.tolerance = {{"q", 0}}, .default_tolerance = 0.25}).passed);
}

TEST(Compare, TheWorstPixelExceedsItsToleranceMost) {
  image::Image actual = shadow_image(8, 8);
  const image::Image golden = golden_of(actual);
  set(actual, "q", 1, 1, 5);          // 5 off, 3 beyond the tolerance
  set(actual, "k_shadow", 6, 7, -3);  // 4 beyond
  const Verdict verdict = compare(actual, golden, {.tolerance = {{"q", 2}}});
  ASSERT_TRUE(verdict.worst);
  EXPECT_EQ(verdict.worst->x, 6);
  EXPECT_EQ(verdict.worst->y, 7);
  EXPECT_EQ(verdict.worst->channel, "k_shadow");
  EXPECT_EQ(verdict.worst->actual, -3);
  EXPECT_EQ(verdict.worst->expected, double{0.4F});
}

TEST(Compare, WhereThereIsNoSurfaceOnlyValidityMatters) {
  image::Image actual = shadow_image(4, 4);
  set(actual, "valid", 0, 0, 0);
  image::Image golden = golden_of(actual);
  set(golden, "k_shadow", 0, 0, 0.1F);
  const Verdict verdict = compare(actual, golden, {});
  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.compared, 15);
}

TEST(Compare, ValidityThatDiffersIsAMismatchEitherWay) {
  image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  set(actual, "valid", 0, 0, 0);
  set(golden, "valid", 3, 3, 0);
  const Verdict verdict = compare(actual, golden, {});
  EXPECT_EQ(verdict.mismatches, 2);
  EXPECT_EQ(verdict.compared, 16);
  EXPECT_EQ(verdict.worst->channel, "valid");
}

TEST(Compare, AMapWithoutAnySurfacePasses) {
  image::Image actual = shadow_image(3, 3);
  add_channel(actual, "valid", 0);
  const Verdict verdict = compare(actual, golden_of(actual), {});
  EXPECT_TRUE(verdict.passed);
  EXPECT_EQ(verdict.compared, 0);
}

TEST(Compare, StepsMatterOnlyWithATolerance) {
  const image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  add_channel(golden, "steps", 100);
  EXPECT_TRUE(compare(actual, golden, {}).passed);
  EXPECT_TRUE(compare(actual, golden, {.default_tolerance = 1}).passed);
  EXPECT_FALSE(compare(actual, golden, {.tolerance = {{"steps", 99}}}).passed);
  EXPECT_TRUE(compare(actual, golden, {.tolerance = {{"steps", 100}}}).passed);
}

TEST(Compare, AChannelThatActualLacksIsNamed) {
  image::Image actual = shadow_image(4, 4);
  const image::Image golden = golden_of(actual);
  actual.channels = {{"b_shadow", actual.channels["b_shadow"]}, {"valid", actual.channels["valid"]}};
  const Verdict verdict = compare(actual, golden, {.max_mismatch = 1});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.measured, "no channel k_shadow (there are b_shadow, valid)");
  EXPECT_EQ(verdict.limit, "channel k_shadow");
}

TEST(Compare, FurtherChannelsOfActualAreIgnored) {
  image::Image actual = shadow_image(4, 4);
  const image::Image golden = golden_of(actual);
  add_channel(actual, "horizon", 1);
  EXPECT_TRUE(compare(actual, golden, {}).passed);
}

TEST(Compare, NamedChannelsAreTheOnlyOnesCompared) {
  image::Image actual = shadow_image(4, 4);
  image::Image golden = golden_of(actual);
  add_channel(golden, "horizon", 1);
  set(golden, "k_shadow", 0, 0, 0.5F);
  EXPECT_TRUE(compare(actual, golden, {.channels = {"b_shadow"}}).passed);
  EXPECT_FALSE(compare(actual, golden, {.max_mismatch = 1, .channels = {"occlusion"}}).passed);
}

TEST(Compare, ImagesOfOtherSizeDoNotPass) {
  const Verdict verdict = compare(shadow_image(4, 3), golden_of(shadow_image(3, 4)), {.max_mismatch = 1});
  EXPECT_FALSE(verdict.passed);
  EXPECT_EQ(verdict.measured, "4x3 pixels");
  EXPECT_EQ(verdict.limit, "3x4 pixels");
}

TEST(Compare, AValueThatIsNotFiniteNeverPasses) {
  for (const float odd : {kNan, kInfinity, -kInfinity}) {
    const image::Image clean = shadow_image(8, 8);
    image::Image broken = clean;
    set(broken, "b_shadow", 3, 4, odd);
    const CompareOptions generous{.max_mismatch = 1, .default_tolerance = 1e30};

    const Verdict in_actual = compare(broken, golden_of(clean), generous);
    EXPECT_FALSE(in_actual.passed);
    EXPECT_EQ(in_actual.measured, "b_shadow is not finite at (3, 4)");

    const Verdict in_golden = compare(clean, golden_of(broken), generous);
    EXPECT_FALSE(in_golden.passed);
    EXPECT_EQ(in_golden.measured, "in the expected image b_shadow is not finite at (3, 4)");

    EXPECT_FALSE(compare(broken, golden_of(broken), generous).passed) << "not even against itself";
  }
}

TEST(Compare, NotFiniteIsFoundInTheBandAndWithoutSurfaceAndInIgnoredChannels) {
  image::Image actual = shadow_image(8, 8);
  set(actual, "valid", 2, 5, 0);
  image::Image golden = golden_of(actual);
  set(golden, "band", 2, 5, 1);
  set(actual, "steps", 2, 5, kNan);
  EXPECT_EQ(compare(actual, golden, {}).measured, "steps is not finite at (2, 5)");
}

TEST(Compare, EmptyImagesDoNotPass) {
  EXPECT_FALSE(compare({}, {}, {.max_mismatch = 1}).passed);
  EXPECT_FALSE(compare(shadow_image(2, 2), {}, {.max_mismatch = 1}).passed);
  EXPECT_FALSE(compare({}, golden_of(shadow_image(2, 2)), {.max_mismatch = 1}).passed);
  image::Image only_band{.width = 2, .height = 2, .channels = {}, .attributes = {}};
  add_channel(only_band, "band", 0);
  EXPECT_FALSE(compare(shadow_image(2, 2), only_band, {.max_mismatch = 1}).passed);
}

}  // namespace
}  // namespace gnomon::judge
