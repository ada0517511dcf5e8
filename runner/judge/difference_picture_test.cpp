// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>

#include "judge/judge.h"
#include "judge/test_image.h"

namespace gnomon::judge {
namespace {

using testing::flip_shadow;
using testing::golden_of;
using testing::set;
using testing::shadow_image;

std::array<int, 3> colour(const image::Picture& picture, int x, int y) {
  const auto first = static_cast<std::size_t>(3 * (y * picture.width + x));
  return {picture.rgb[first], picture.rgb[first + 1], picture.rgb[first + 2]};
}

bool is_grey(std::array<int, 3> c) {
  return c[0] == c[1] && c[1] == c[2];
}
bool is_red(std::array<int, 3> c) {
  return c[0] > 3 * c[1] && c[0] > 3 * c[2];
}
bool is_yellow(std::array<int, 3> c) {
  return c[0] > 3 * c[2] && c[1] > 3 * c[2];
}

TEST(DifferencePicture, ShowsWhereAndWhetherTheBandExcusesIt) {
  const image::Image actual = shadow_image(8, 6);
  image::Image golden = golden_of(actual);
  flip_shadow(golden, 2, 1);
  flip_shadow(golden, 5, 4);
  set(golden, "band", 5, 4, 1);
  const image::Picture picture = difference_picture(actual, golden, {});
  ASSERT_EQ(picture.rgb.size(), 3U * 8 * 6);
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      EXPECT_EQ(is_red(colour(picture, x, y)), x == 2 && y == 1);
      EXPECT_EQ(is_yellow(colour(picture, x, y)), x == 5 && y == 4);
    }
  }
  EXPECT_TRUE(is_red(colour(difference_picture(actual, golden, {.band = false}), 5, 4)));
}

TEST(DifferencePicture, KeepsTheExpectedShadowRecognisable) {
  const image::Image image = shadow_image(4, 4);
  const image::Picture picture = difference_picture(image, golden_of(image), {});
  EXPECT_TRUE(is_grey(colour(picture, 0, 0)));
  EXPECT_GT(colour(picture, 0, 0)[0], colour(picture, 1, 0)[0]) << "lit is brighter than shadow";
}

TEST(DifferencePicture, DarkensWhereThereIsNoSurface) {
  image::Image image = shadow_image(4, 4);
  set(image, "valid", 1, 0, 0);
  const image::Picture picture = difference_picture(image, golden_of(image), {});
  EXPECT_LT(colour(picture, 1, 0)[0], colour(picture, 3, 0)[0]);
}

TEST(DifferencePicture, IsAllRedForImagesThatCannotBeCompared) {
  const image::Picture picture = difference_picture(shadow_image(3, 3), golden_of(shadow_image(5, 2)), {});
  ASSERT_EQ(picture.width, 5);
  ASSERT_EQ(picture.height, 2);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_TRUE(is_red(colour(picture, x, y)));
  }
}

TEST(DifferencePicture, ShowsValuesThatAreNotFinite) {
  image::Image actual = shadow_image(3, 3);
  const image::Image golden = golden_of(actual);
  set(actual, "k_shadow", 1, 1, testing::kNan);
  EXPECT_TRUE(is_red(colour(difference_picture(actual, golden, {}), 1, 1)));
}

TEST(DifferencePicture, OfNothingIsEmpty) {
  const image::Picture picture = difference_picture({}, {}, {});
  EXPECT_EQ(picture.width, 0);
  EXPECT_TRUE(picture.rgb.empty());
}

}  // namespace
}  // namespace gnomon::judge
