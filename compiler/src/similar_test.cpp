// SPDX-License-Identifier: MIT
#include "similar.h"

#include <gtest/gtest.h>

namespace gnomon::compiler {
namespace {

TEST(Similar, OneMistakeInFourLetters) {
  const std::string_view text = "float height; vec3 direction; int i;";
  EXPECT_EQ(similar_word("hieght", text), "height");
  EXPECT_EQ(similar_word("heigt", text), "height");
  EXPECT_EQ(similar_word("heighht", text), "height");
  EXPECT_EQ(similar_word("directoin", text), "direction");
}

TEST(Similar, NothingWhereItIsAGuess) {
  const std::string_view text = "float height; vec3 direction; int i;";
  EXPECT_EQ(similar_word("height", text), "");
  EXPECT_EQ(similar_word("h", text), "");
  EXPECT_EQ(similar_word("hgt", text), "");
  EXPECT_EQ(similar_word("altitude", text), "");
  EXPECT_EQ(similar_word(std::string(1 << 20, 'x'), text), "");
}

}  // namespace
}  // namespace gnomon::compiler
