// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

const MapModules kFlat(flat_map(4, 4));

TEST(PatchOf, PatchAndFractionGiveTheCoordinateBack) {
  for (int i = 0; i < 4000; ++i) {
    const float column = static_cast<float>(i) * 4.0917F;
    float fraction = -1;
    const int patch = kFlat.gnomon_patch_of(column, fraction);
    EXPECT_GE(fraction, 0.0F);
    EXPECT_LE(fraction, 1.0F);
    EXPECT_EQ(double{column}, patch - 0.5 + double{fraction}) << "column " << column;
  }
}

TEST(ReceiverAt, SampleIsTheNorthWestCornerOfItsOwnPatch) {
  const auto receiver = kFlat.gnomon_receiver_at(7.5F, 2.5F, 3.0F);
  EXPECT_EQ(receiver.patch_index, ivec2(8, 3));
  EXPECT_EQ(receiver.fraction, vec2(0, 0));
  EXPECT_EQ(receiver.height, 3.0F);
}

}  // namespace
}  // namespace gnomon::modules
