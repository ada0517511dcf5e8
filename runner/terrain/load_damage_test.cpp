// SPDX-License-Identifier: MIT
// What damaged and lying files do: an error, never a crash, and nothing is printed.
#include <algorithm>
#include <iterator>

#include "terrain/load_fixture.h"

namespace gnomon::terrain {
namespace {

using LoadDamageTest = LoadFiles;

/// Every beginning of a file, and it with bytes changed: an error or heights, never a crash, and nothing is
/// printed. `must_fail`: a file that lacks its end is an error.
void torture(const std::string& file, const std::string& hurt, const LoadOptions& options) {
  std::ifstream stream(file, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  const auto load = [&](const std::string& bytes) {
    std::ofstream(hurt, std::ios::binary) << bytes;
    return load_height_map(hurt, options);
  };
  ASSERT_TRUE(load(whole).ok());
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const std::size_t step = std::max<std::size_t>(whole.size() / 300, 1);
  for (std::size_t length = 0; length < whole.size(); length += step) {
    const auto loaded = load(whole.substr(0, length));
    EXPECT_TRUE(loaded.ok() || !loaded.diagnostics()[0].message.empty());
  }
  unsigned state = 1;
  for (int round = 0; round < 300; ++round) {
    std::string bytes = whole;
    for (int k = 0; k < 4; ++k) {
      state = state * 1664525u + 1013904223u;
      bytes[(state >> 8) % bytes.size()] = static_cast<char>(state >> 24);
    }
    const auto loaded = load(bytes);
    EXPECT_TRUE(!loaded.ok() || loaded->map.samples.size() ==
                                    std::size_t(loaded->map.width) * std::size_t(loaded->map.height));
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(LoadDamageTest, DamagedGeoTiffs) {
  TestFile file = utm();
  torture(write("a.tif", file), path("hurt.tif"), {});
  file.options = {"COMPRESS=DEFLATE", "TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"};
  torture(write("b.tif", file), path("hurt.tif"), {});
}

TEST_F(LoadDamageTest, DamagedAsciiGrids) {
  TestFile file = utm();
  file.driver = "AAIGrid";
  file.transform = {{380000, 30, 0, 3800000, 0, -30}};
  torture(write("a.asc", file), path("hurt.asc"), {});
}

TEST_F(LoadDamageTest, DamagedUsgsDems) {
  TestFile file = utm();
  file.driver = "USGSDEM";
  file.type = "Int16";
  file.crs = "EPSG:26711";
  file.transform = {{379995, 30, 0, 3800025, 0, -30}};
  torture(write("a.dem", file), path("hurt.dem"), {});
}

TEST_F(LoadDamageTest, WhatLacksItsEndIsAnError) {
  TestFile file = utm();
  const auto cut = [&](const std::string& name, std::size_t bytes) {
    fs::resize_file(path(name), fs::file_size(path(name)) - bytes);
    return refusal(load_height_map(path(name), {}));
  };
  // The plain TIFF ends with its numbers, the tiled one too.
  write("a.tif", file);
  EXPECT_SAYS(cut("a.tif", 4), "damaged or incomplete");
  file.options = {"TILED=YES", "BLOCKXSIZE=16", "BLOCKYSIZE=16"};
  write("b.tif", file);
  EXPECT_SAYS(cut("b.tif", 40), "damaged or incomplete");
  file.driver = "AAIGrid";
  file.options.clear();
  file.transform = {{380000, 30, 0, 3800000, 0, -30}};
  write("a.asc", file);
  EXPECT_SAYS(cut("a.asc", 8), "damaged or incomplete");
}

TEST_F(LoadDamageTest, LyingAsciiGrids) {
  const auto load = [&](const std::string& size, const std::string& heights) {
    return refusal(
        load_height_map(write_text("a.asc", size + "xllcorner 0\nyllcorner 0\ncellsize 10\n" + heights), {}));
  };
  EXPECT_SAYS(load("ncols 2\nnrows 2\n", "1 2\n3 x\n"), "damaged");
  EXPECT_SAYS(load("ncols 2\nnrows 2\n", "1 2\n3 4\n5 6\n"), "damaged");
  EXPECT_SAYS(load("ncols 3\nnrows 2\n", "1 2\n3 4\n"), "damaged");
  EXPECT_SAYS(load("ncols 16384\nnrows 16384\n", "1 2\n3 4\n"), "damaged");
  EXPECT_SAYS(load("ncols 100000\nnrows 2\n", "1 2\n3 4\n"), "limit");
}

}  // namespace
}  // namespace gnomon::terrain
