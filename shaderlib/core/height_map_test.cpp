// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "testing/map_modules.h"

namespace gnomon::modules {
namespace {

TEST(IsSample, TellsEveryHeightFromNone) {
  const MapModules modules(flat_map(2, 2));
  EXPECT_EQ(GNOMON_NO_SAMPLE, terrain::kNoSample);
  for (const double height : {0.0, -terrain::kHighestHeight, terrain::kHighestHeight}) {
    EXPECT_TRUE(modules.gnomon_is_sample(static_cast<float>(height)));
    EXPECT_TRUE(terrain::is_sample(static_cast<float>(height)));
  }
  EXPECT_FALSE(modules.gnomon_is_sample(GNOMON_NO_SAMPLE));
  EXPECT_FALSE(terrain::is_sample(terrain::kNoSample));
}

}  // namespace
}  // namespace gnomon::modules
