// SPDX-License-Identifier: MIT
// What is particular to heights; image/stored_image_test.cpp holds the formats and the damaged files.
#include "terrain/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <utility>
#include <vector>

#include "image/image.h"

namespace gnomon::terrain {
namespace {

namespace fs = std::filesystem;

class LoadTest : public testing::Test {
 protected:
  LoadTest() { fs::create_directories(folder_); }
  ~LoadTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  [[nodiscard]] std::string write_exr(const std::map<std::string, std::vector<float>>& channels) const {
    const int width = static_cast<int>(channels.begin()->second.size());
    const image::Image image{.width = width, .height = 1, .channels = channels, .attributes = {}};
    EXPECT_TRUE(image::write_exr(path("a.exr"), image).ok());
    return path("a.exr");
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("gnomon-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// One row of floats as an uncompressed little-endian TIFF file; image/ itself writes finite values only.
std::string tiff_of(const std::vector<float>& values) {
  std::string bytes("II*\0\x08\0\0\0", 8);
  const auto append = [&](std::size_t number, int count) {
    for (int k = 0; k < count; ++k) bytes.push_back(static_cast<char>(number >> (8 * k) & 0xff));
  };
  const std::size_t size = values.size() * sizeof(float);
  const std::vector<std::pair<std::size_t, std::size_t>> entries{
      {256, values.size()}, {257, 1}, {258, 32}, {259, 1},    {262, 1},
      {273, 134},           {277, 1}, {278, 1},  {279, size}, {339, 3}};
  append(entries.size(), 2);
  for (const auto& [tag, value] : entries) append(tag, 2), append(4, 2), append(1, 4), append(value, 4);
  append(0, 4);
  bytes.append(reinterpret_cast<const char*>(values.data()), size);
  return bytes;
}

std::string refusal(const Result<LoadedHeightMap>& loaded) {
  if (loaded.ok()) return "nothing was refused";
  EXPECT_EQ(loaded.diagnostics()[0].failure, Failure::kInvalid);
  return loaded.diagnostics()[0].message;
}

TEST_F(LoadTest, TheCarriedModelIsWhereItIsSaidToBe) {
  const auto loaded = load_height_map(GNOMON_CARRIED_MODEL, {.spacing = {{74.85, 92.47}}});
  ASSERT_TRUE(loaded.ok()) << to_string(loaded.diagnostics()[0]);
  const HeightMap& map = loaded->map;
  EXPECT_EQ(map.width, 403);
  EXPECT_EQ(map.height, 344);
  EXPECT_EQ(map.domain_width, 403);
  EXPECT_EQ(map.domain_height, 344);
  EXPECT_EQ(map.spacing_x, 74.85);
  EXPECT_EQ(map.spacing_y, 92.47);
  const auto [lowest, highest] = std::minmax_element(map.samples.begin(), map.samples.end());
  EXPECT_EQ(*lowest, 236);
  EXPECT_EQ(*highest, 1076);
  // Cross Mountain, in the south of the map, and the town of Rocky Top in the valley south-east of it.
  EXPECT_EQ(map.at(297, 219), 1076);
  EXPECT_NEAR(map.at(268, 309), 262, 10);
  EXPECT_TRUE(loaded->notes.empty());
}

TEST_F(LoadTest, WithoutASpacingOneMetreIsAssumedAndSaid) {
  const auto loaded = load_height_map(GNOMON_CARRIED_MODEL, {});
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->map.spacing_x, 1);
  EXPECT_EQ(loaded->map.spacing_y, 1);
  ASSERT_EQ(loaded->notes.size(), 1u);
  EXPECT_NE(loaded->notes[0].find("1 m"), std::string::npos);
}

TEST_F(LoadTest, TheVerticalScaleIsAppliedInDoubleAndRoundedOnce) {
  const auto loaded = load_height_map(GNOMON_CARRIED_MODEL, {.vertical_scale = 0.1});
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->map.at(297, 219), static_cast<float>(1076 * 0.1));

  const auto floats = load_height_map(write_exr({{"Y", {3.0f, 0.7f}}}), {.vertical_scale = 0.3048});
  ASSERT_TRUE(floats.ok());
  EXPECT_EQ(floats->map.samples[0], static_cast<float>(3.0 * 0.3048));
  EXPECT_EQ(floats->map.samples[1], static_cast<float>(static_cast<double>(0.7f) * 0.3048));
}

TEST_F(LoadTest, ChannelsAreChosenByName) {
  const std::string file = write_exr({{"height", {1, 2}}, {"slope", {3, 4}}});
  EXPECT_NE(refusal(load_height_map(file, {})).find("height, slope"), std::string::npos);
  EXPECT_NE(refusal(load_height_map(file, {.channel = "depth"})).find("height, slope"), std::string::npos);
  const auto loaded = load_height_map(file, {.channel = "slope"});
  ASSERT_TRUE(loaded.ok());
  EXPECT_EQ(loaded->map.samples, (std::vector<float>{3, 4}));
  EXPECT_TRUE(load_height_map(write_exr({{"anything", {1}}}), {}).ok());
}

TEST_F(LoadTest, NaNIsNoDataAndInfiniteHeightsAreRefusedWithTheirPlace) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  const auto load = [&](const std::vector<float>& values) {
    std::ofstream(path("a.tif"), std::ios::binary) << tiff_of(values);
    return load_height_map(path("a.tif"), {});
  };
  const auto finite = load({1.5f, -2.0f, 8848.0f});
  ASSERT_TRUE(finite.ok()) << to_string(finite.diagnostics()[0]);
  EXPECT_EQ(finite->map.samples, (std::vector<float>{1.5f, -2.0f, 8848.0f}));
  const auto pierced = load({1, kNaN, 2});
  ASSERT_TRUE(pierced.ok());
  EXPECT_EQ(pierced->map.samples, (std::vector<float>{1, kNoSample, 2}));
  EXPECT_TRUE(pierced->map.holes);
  EXPECT_FALSE(finite->map.holes);
  EXPECT_NE(refusal(load({1, 2, -kInfinity}))
                .find("column 2, row 0 (counted from 0 in the north-west) is infinite"),
            std::string::npos);
}

TEST_F(LoadTest, HeightsThatAreTooHighForSinglePrecisionAreRefused) {
  const std::string message = refusal(load_height_map(write_exr({{"Y", {0, 3e38f}}}), {}));
  EXPECT_NE(message.find("column 1, row 0"), std::string::npos) << message;
  EXPECT_FALSE(load_height_map(write_exr({{"Y", {0, 1e30f}}}), {.vertical_scale = 1e10}).ok());
}

TEST_F(LoadTest, TheLimitIsNamed) {
  EXPECT_NE(refusal(load_height_map(GNOMON_CARRIED_MODEL, {.max_size = 400}))
                .find("403 x 344 samples; the limit is 400"),
            std::string::npos);
}

TEST_F(LoadTest, WhatIsNoImageIsRefused) {
  EXPECT_NE(refusal(load_height_map(path("missing.tif"), {})).find("no such file"), std::string::npos);
  EXPECT_NE(refusal(load_height_map(testing::TempDir(), {})).find("folder"), std::string::npos);
}

}  // namespace
}  // namespace gnomon::terrain
