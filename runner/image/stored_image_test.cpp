// SPDX-License-Identifier: MIT
#include "image/stored_image.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace gnomon::image {
namespace {

namespace fs = std::filesystem;

/// A folder of the test's own, gone at its end.
class StoredImageTest : public testing::Test {
 protected:
  StoredImageTest() { fs::create_directories(folder_); }
  ~StoredImageTest() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  /// Writes an image with OpenImageIO itself; `numbers` are width * height * channels of the type that `type`
  /// says.
  template <class Number>
  std::string write(const std::string& name, OIIO::ImageSpec spec, const std::vector<Number>& numbers) const {
    const auto output = OIIO::ImageOutput::create(path(name));
    EXPECT_TRUE(output->open(path(name), spec)) << output->geterror();
    EXPECT_TRUE(output->write_image(spec.format, numbers.data())) << output->geterror();
    EXPECT_TRUE(output->close());
    return path(name);
  }

  [[nodiscard]] std::string write_bytes(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  /// A 40 x 30 image of the extension's usual type, hard to compress.
  [[nodiscard]] std::string write_noise(const std::string& extension) const {
    const bool is_float = extension == "exr";
    std::vector<float> floats;
    std::vector<std::uint16_t> integers;
    for (std::uint32_t i = 0; i < 1200; ++i) {
      integers.push_back(static_cast<std::uint16_t>(i * 40503u));
      floats.push_back(static_cast<float>(integers.back()) / 7.0f);
    }
    const OIIO::ImageSpec spec(40, 30, 1, is_float ? OIIO::TypeFloat : OIIO::TypeUInt16);
    return is_float ? write("noise." + extension, spec, floats) : write("noise." + extension, spec, integers);
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("gnomon-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<double> values(const StoredImage& image, std::size_t channel = 0) {
  std::vector<double> all;
  for (std::size_t i = 0; i < image.pixels(); ++i) all.push_back(image.value(i, channel));
  return all;
}

void expect_numbers(const Result<StoredImage>& image, const std::vector<double>& numbers) {
  ASSERT_TRUE(image.ok()) << to_string(image.diagnostics()[0]);
  EXPECT_EQ(values(*image), numbers);
}

/// The message of a refusal, which must be one sentence about invalid input.
std::string refusal(const Result<StoredImage>& image) {
  if (image.ok()) return "nothing was refused";
  EXPECT_EQ(image.diagnostics().size(), 1u);
  EXPECT_EQ(image.diagnostics()[0].failure, Failure::kInvalid);
  EXPECT_EQ(image.diagnostics()[0].message.find('\n'), std::string::npos);
  return image.diagnostics()[0].message;
}

TEST_F(StoredImageTest, NumbersAreThoseOfTheFile) {
  using OIIO::ImageSpec;
  expect_numbers(
      read_stored(
          write("8.png", ImageSpec(2, 2, 1, OIIO::TypeUInt8), std::vector<std::uint8_t>{0, 1, 128, 255}), {}),
      {0, 1, 128, 255});
  expect_numbers(read_stored(write("16.png", ImageSpec(2, 2, 1, OIIO::TypeUInt16),
                                   std::vector<std::uint16_t>{0, 1, 1076, 65535}),
                             {}),
                 {0, 1, 1076, 65535});
  expect_numbers(read_stored(write("16.tif", ImageSpec(2, 2, 1, OIIO::TypeInt16),
                                   std::vector<std::int16_t>{-32768, -430, 0, 8848}),
                             {}),
                 {-32768, -430, 0, 8848});
  expect_numbers(read_stored(write("32.tif", ImageSpec(3, 1, 1, OIIO::TypeUInt32),
                                   std::vector<std::uint32_t>{0, 16777217, 4294967295}),
                             {}),
                 {0, 16777217, 4294967295});
  expect_numbers(
      read_stored(write("32.exr", ImageSpec(2, 1, 1, OIIO::TypeFloat), std::vector<float>{0.1f, -3e38f}), {}),
      {0.1f, -3e38f});
}

TEST_F(StoredImageTest, NumbersThatCannotBeReadExactlyAreRefused) {
  const std::string file =
      write("64.tif", {2, 1, 1, OIIO::TypeDesc::DOUBLE}, std::vector<double>{0.1, -1e300});
  EXPECT_NE(refusal(read_stored(file, {})).find("of type double"), std::string::npos);
}

TEST_F(StoredImageTest, ColoursAreNotMultipliedByAlpha) {
  OIIO::ImageSpec spec(1, 1, 4, OIIO::TypeUInt8);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  const std::string file = write("rgba.png", spec, std::vector<std::uint8_t>{200, 100, 50, 128});
  expect_numbers(read_stored(file, {.channel = "R"}), {200});
}

TEST_F(StoredImageTest, TheFirstRowOfTheFileIsTheFirstRow) {
  const std::string file =
      write("rows.tif", {1, 3, 1, OIIO::TypeUInt8}, std::vector<std::uint8_t>{10, 20, 30});
  expect_numbers(read_stored(file, {}), {10, 20, 30});
}

TEST_F(StoredImageTest, StripsKeepRowsAndChannelsApart) {
  OIIO::ImageSpec spec(2, 3, 3, OIIO::TypeFloat);
  spec.attribute("tiff:RowsPerStrip", 1);
  std::vector<float> numbers;
  for (int i = 0; i < 18; ++i) numbers.push_back(0.5f * static_cast<float>(i));
  const std::string file = write("strips.tif", spec, numbers);
  const auto all = read_stored(file, {});
  ASSERT_TRUE(all.ok()) << to_string(all.diagnostics()[0]);
  EXPECT_EQ(values(*all, 0), (std::vector<double>{0, 1.5, 3, 4.5, 6, 7.5}));
  EXPECT_EQ(values(*all, 2), (std::vector<double>{1, 2.5, 4, 5.5, 7, 8.5}));
  expect_numbers(read_stored(file, {.channel = "G"}), {0.5, 2, 3.5, 5, 6.5, 8});
}

TEST_F(StoredImageTest, HalvesAreWidenedExactly) {
  // 1, -2, 65504 and the smallest subnormal as 16-bit floats.
  const std::vector<std::uint16_t> bits{0x3c00, 0xc000, 0x7bff, 0x0001};
  for (const char* name : {"half.exr", "half.tif"})
    expect_numbers(read_stored(write(name, {4, 1, 1, OIIO::TypeHalf}, bits), {}), {1, -2, 65504, 0x1p-24});
}

TEST_F(StoredImageTest, TheNameOfTheFileDoesNotMatter) {
  const std::string file = write("a.png", {1, 1, 1, OIIO::TypeUInt8}, std::vector<std::uint8_t>{7});
  fs::rename(file, path("a.tif"));
  expect_numbers(read_stored(path("a.tif"), {}), {7});
}

TEST_F(StoredImageTest, OneOfManyChannelsMustBeNamed) {
  const std::string file = write("rgb.png", {1, 1, 3, OIIO::TypeUInt8}, std::vector<std::uint8_t>{9, 9, 9});
  const std::string message = refusal(read_stored(file, {.one_channel = true}));
  EXPECT_NE(message.find("R, G, B"), std::string::npos) << message;
  EXPECT_NE(message.find("--channel"), std::string::npos) << message;
  EXPECT_NE(
      refusal(read_stored(file, {.one_channel = true, .channel = "height"})).find("'height'; it has R, G, B"),
      std::string::npos);
  const auto green = read_stored(file, {.one_channel = true, .channel = "G"});
  expect_numbers(green, {9});
  EXPECT_EQ(green->channels, std::vector<std::string>{"G"});
}

TEST_F(StoredImageTest, ASingleChannelIsTakenWhateverItIsCalled) {
  const std::string file = write("y.png", {1, 1, 1, OIIO::TypeUInt8}, std::vector<std::uint8_t>{5});
  expect_numbers(read_stored(file, {.one_channel = true, .channel = "height"}), {5});
}

TEST_F(StoredImageTest, WhatIsNoImageFileIsSaidToBeNone) {
  EXPECT_NE(refusal(read_stored(path("missing.png"), {})).find("no such file"), std::string::npos);
  EXPECT_NE(refusal(read_stored(path(""), {})).find("folder"), std::string::npos);
  EXPECT_NE(refusal(read_stored(write_bytes("text.png", "not a picture\n"), {})).find("not an image"),
            std::string::npos);
  EXPECT_NE(refusal(read_stored(write_bytes("empty.exr", ""), {})).find("not an image"), std::string::npos);
  EXPECT_NE(refusal(read_stored(write_bytes("four.tif", std::string("II*\0", 4)), {})).find("opened"),
            std::string::npos);
}

TEST_F(StoredImageTest, TruncatedFilesAreRefusedWhereverTheyEnd) {
  for (const std::string extension : {"png", "exr", "tif"}) {
    const std::string whole = bytes_of(write_noise(extension));
    ASSERT_TRUE(read_stored(path("noise." + extension), {}).ok());
    for (std::size_t length = 0; length < whole.size(); length += 1 + whole.size() / 60)
      EXPECT_FALSE(read_stored(write_bytes("cut." + extension, whole.substr(0, length)), {}).ok())
          << extension << " cut to " << length << " of " << whole.size() << " bytes";
  }
}

TEST_F(StoredImageTest, DamageInAPngIsFoundWhereverItIsAndNothingIsPrinted) {
  const std::string whole = bytes_of(write_noise("png"));
  testing::internal::CaptureStderr();
  for (std::size_t place = 0; place < whole.size(); place += 1 + whole.size() / 60) {
    std::string bytes = whole;
    bytes[place] = static_cast<char>(bytes[place] ^ 0x55);
    EXPECT_FALSE(read_stored(write_bytes("damaged.png", bytes), {}).ok()) << "byte " << place;
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(StoredImageTest, DamagedStripsOfATiffAreFound) {
  std::vector<std::uint16_t> numbers;
  for (std::uint32_t i = 0; i < 3600; ++i)
    numbers.push_back(static_cast<std::uint16_t>((i * i * 40503u >> 7) & 0x3f3fu));
  const std::string whole = bytes_of(write("strips.tif", {40, 90, 1, OIIO::TypeUInt16}, numbers));
  int damaged = 0, found = 0;
  for (std::size_t place = whole.size() / 4; place < whole.size() / 2; place += 5, ++damaged) {
    std::string bytes = whole;
    bytes[place] = static_cast<char>(bytes[place] ^ 0x55);
    if (!read_stored(write_bytes("damaged.tif", bytes), {}).ok()) ++found;
  }
  // The format's own checksum is not always looked at by libtiff, so a few go through.
  EXPECT_GT(found, damaged / 2) << found << " of " << damaged;
}

TEST_F(StoredImageTest, AHugeHeaderWithoutDataNamesTheLimit) {
  // A PNG of 20000 x 20000 16-bit samples that ends after its header.
  const std::string png("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\x4e\x20\0\0\x4e\x20\x10\0\0\0\0\x96\x8b\xc5\xa6",
                        33);
  const std::string message = refusal(read_stored(write_bytes("huge.png", png), {.max_size = 16384}));
  EXPECT_EQ(message, "the image has 20000 x 20000 samples; the limit is 16384 on each side");

  // A TIFF of that size: one directory of eleven entries, one strip that is not there.
  std::string tiff("II*\0\x08\0\0\0", 8);
  const auto append = [&](std::uint32_t number, int bytes) {
    for (int k = 0; k < bytes; ++k) tiff.push_back(static_cast<char>(number >> (8 * k)));
  };
  const std::vector<std::array<std::uint32_t, 2>> entries{{256, 20000}, {257, 20000}, {258, 16}, {259, 1},
                                                          {262, 1},     {273, 1000},  {277, 1},  {278, 20000},
                                                          {279, 8000},  {284, 1},     {339, 1}};
  append(static_cast<std::uint32_t>(entries.size()), 2);
  for (const auto& [tag, value] : entries) {
    constexpr std::uint32_t kLong = 4;
    append(tag, 2), append(kLong, 2), append(1, 4), append(value, 4);
  }
  append(0, 4);
  EXPECT_EQ(refusal(read_stored(write_bytes("huge.tif", tiff), {.max_size = 16384})), message);
  EXPECT_NE(refusal(read_stored(write_bytes("huge.tif", tiff), {})).find("incomplete"), std::string::npos);
}

TEST_F(StoredImageTest, LimitIsInclusive) {
  const std::string file = write("3.png", {3, 1, 1, OIIO::TypeUInt8}, std::vector<std::uint8_t>{1, 2, 3});
  EXPECT_TRUE(read_stored(file, {.max_size = 3}).ok());
  EXPECT_FALSE(read_stored(file, {.max_size = 2}).ok());
}

}  // namespace
}  // namespace gnomon::image
