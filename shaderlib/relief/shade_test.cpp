// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(4, 4));

TEST(Shade, DarkAtTheHorizonBrightAtTheZenithAndOneWhereLit) {
  EXPECT_EQ(kFlat.gnomon_k_shadow(1, 0, 0.2F, 0.6F), 0.2F);
  EXPECT_EQ(kFlat.gnomon_k_shadow(1, 1, 0.2F, 0.6F), 0.2F + (0.6F - 0.2F));
  EXPECT_EQ(kFlat.gnomon_k_shadow(0, 0.3F, 0.2F, 0.6F), 1.0F);
}

TEST(Shade, NeverDarkerThanDarkUnderTheHorizon) {
  EXPECT_EQ(kFlat.gnomon_k_shadow(1, -1, 0.2F, 0.6F), 0.2F);
}

TEST(Shade, IsDefinedForBlackShadow) {
  EXPECT_EQ(kFlat.gnomon_k_shadow(0, 0, 0, 0), 1.0F);
}

TEST(Shade, DarkensAsTheSunIsCovered) {
  for (float shadow = 0; shadow < 1; shadow += 0.0625F) {
    EXPECT_GT(kFlat.gnomon_k_shadow(shadow, 0.5F, 0.2F, 0.6F),
              kFlat.gnomon_k_shadow(shadow + 0.0625F, 0.5F, 0.2F, 0.6F));
  }
}

}  // namespace
}  // namespace gnomon::modules
