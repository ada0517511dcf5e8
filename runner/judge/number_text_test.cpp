// SPDX-License-Identifier: MIT
#include "judge/number_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon::judge {
namespace {

TEST(NumberText, IsTheShortestDecimalOfASinglePrecisionValue) {
  EXPECT_EQ(number_text(double{0.2F}), "0.2");
  EXPECT_EQ(number_text(1), "1");
}

TEST(NumberText, TellsNeighbouringValuesApart) {
  EXPECT_NE(number_text(double{0.2F}), number_text(double{std::nextafter(0.2F, 1.0F)}));
  EXPECT_NE(number_text(0.2), number_text(std::nextafter(0.2, 1.0)));
}

TEST(NumberText, TakesWhatSinglePrecisionCannotHold) {
  EXPECT_EQ(number_text(1e300), "1e+300");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(PercentText, HasThreeDigits) {
  EXPECT_EQ(percent_text(9.0 / 65536), "0.0137 %");
  EXPECT_EQ(percent_text(1), "100 %");
}

TEST(PercentText, KeepsASmallShareApartFromNone) {
  EXPECT_EQ(percent_text(0), "0");
  EXPECT_EQ(percent_text(1e-9), "1e-07 %");
}

}  // namespace
}  // namespace gnomon::judge
