// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(4, 4));

TEST(Shadow, HoldsWhatItIsMadeOf) {
  const auto shadow = kFlat.gnomon_shadow(1.0F, 17, GNOMON_CAUSE_SURFACE);
  EXPECT_EQ(shadow.shadow, 1.0F);
  EXPECT_EQ(shadow.steps, 17);
  EXPECT_EQ(shadow.cause, GNOMON_CAUSE_SURFACE);
}

TEST(SunWithoutRay, BelowOrAtThePlaneIsShadowAndZenithIsLit) {
  EXPECT_EQ(kFlat.gnomon_shadow_without_ray(vec3(1, 0, 0)).shadow, 1.0F);
  EXPECT_EQ(kFlat.gnomon_shadow_without_ray(vec3(0.6F, 0, -0.8F)).cause, GNOMON_CAUSE_SUN_BELOW);
  EXPECT_EQ(kFlat.gnomon_shadow_without_ray(vec3(0, 0, 1)).cause, GNOMON_CAUSE_ZENITH);
  EXPECT_EQ(kFlat.gnomon_shadow_without_ray(vec3(0, 0, 1)).shadow, 0.0F);
  EXPECT_EQ(kFlat.gnomon_shadow_without_ray(vec3(0.6F, 0, 0.8F)).cause, GNOMON_CAUSE_UNDECIDED);
}

}  // namespace
}  // namespace gnomon::modules
