// SPDX-License-Identifier: MIT
#include "image/image.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace gnomon::image {
namespace {

namespace fs = std::filesystem;

class ImageTest : public testing::Test {
 protected:
  ImageTest() { fs::create_directories(folder_); }
  ~ImageTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_))
      names.push_back(entry.path().filename().string());
    return names;
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("gnomon-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Image rendered() {
  Image image{.width = 7, .height = 3, .channels = {}, .attributes = {}};
  for (const char* name : {"steps", "b_shadow", "k_shadow", "R", "valid"}) {
    std::vector<float>& values = image.channels[name];
    for (int i = 0; i < 21; ++i) values.push_back(0.1f * static_cast<float>(i) + static_cast<float>(name[0]));
  }
  image.channels["steps"][5] = std::numeric_limits<float>::max();
  image.channels["steps"][6] = -std::numeric_limits<float>::denorm_min();
  image.attributes = {
      {"gnomon:scene", "a/b@elevation=10,q=2"}, {"gnomon:version", "0.1.0"}, {"Software", "gnomon"}};
  return image;
}

void expect_machine_failure(const Result<Done>& written) {
  ASSERT_FALSE(written.ok());
  EXPECT_EQ(written.diagnostics()[0].failure, Failure::kMachine);
}

TEST_F(ImageTest, ExrKeepsEveryChannelToTheBitAndTheAttributes) {
  const Image image = rendered();
  ASSERT_TRUE(write_exr(path("a.exr"), image).ok());
  const auto read = read_image(path("a.exr"));
  ASSERT_TRUE(read.ok()) << to_string(read.diagnostics()[0]);
  EXPECT_EQ(read->width, 7);
  EXPECT_EQ(read->height, 3);
  EXPECT_EQ(read->channels, image.channels);
  EXPECT_EQ(read->attributes, image.attributes);
}

TEST_F(ImageTest, EqualImagesMakeEqualFilesAtAnyTime) {
  Picture picture{2, 2, std::vector<unsigned char>(12, 77)};
  ASSERT_TRUE(write_exr(path("1.exr"), rendered()).ok());
  ASSERT_TRUE(write_png(path("1.png"), picture).ok());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // dates in headers count seconds
  ASSERT_TRUE(write_exr(path("2.exr"), rendered()).ok());
  ASSERT_TRUE(write_png(path("2.png"), picture).ok());
  for (const std::string extension : {".exr", ".png"})
    EXPECT_EQ(bytes_of(path("1" + extension)), bytes_of(path("2" + extension))) << extension;
}

TEST_F(ImageTest, PngHoldsThePictureFromTheTop) {
  const Picture picture{2, 1, {255, 0, 1, 2, 3, 4}};
  ASSERT_TRUE(write_png(path("a.png"), picture).ok());
  const auto read = read_image(path("a.png"));
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->channels,
            (std::map<std::string, std::vector<float>>{{"R", {255, 2}}, {"G", {0, 3}}, {"B", {1, 4}}}));
}

TEST_F(ImageTest, ValuesThatAreNotFiniteAreRefusedAndTheOlderFileStays) {
  ASSERT_TRUE(write_exr(path("a.exr"), rendered()).ok());
  const std::string before = bytes_of(path("a.exr"));
  for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Image image = rendered();
    image.channels["valid"][9] = bad;
    const auto written = write_exr(path("a.exr"), image);
    expect_machine_failure(written);
    EXPECT_NE(written.diagnostics()[0].message.find("'valid'"), std::string::npos);
    EXPECT_NE(written.diagnostics()[0].message.find("(2, 1)"), std::string::npos);
  }
  EXPECT_EQ(bytes_of(path("a.exr")), before);
  EXPECT_EQ(files(), std::vector<std::string>{"a.exr"});
}

TEST_F(ImageTest, PlacesThatCannotBeWrittenAreTheMachinesFailure) {
  expect_machine_failure(write_exr(path("no/such/folder/a.exr"), rendered()));
  fs::create_directory(path("folder"));
  expect_machine_failure(write_exr(path("folder"), rendered()));
  expect_machine_failure(write_exr("/dev/full", rendered()));
  EXPECT_EQ(files(), std::vector<std::string>{"folder"});
}

TEST_F(ImageTest, ChannelsOfTheWrongSizeAreRefused) {
  Image image = rendered();
  image.channels["valid"].pop_back();
  expect_machine_failure(write_exr(path("a.exr"), image));
  expect_machine_failure(
      write_exr(path("a.exr"), {.width = 1, .height = 1, .channels = {}, .attributes = {}}));
  expect_machine_failure(write_png(path("a.png"), {2, 2, {0, 0, 0}}));
  EXPECT_TRUE(files().empty());
}

}  // namespace
}  // namespace gnomon::image
