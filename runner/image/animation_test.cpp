// SPDX-License-Identifier: MIT
#include "image/animation.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace gnomon::image {
namespace {

/// A picture of one colour.
Picture plain(int width, int height, unsigned char red, unsigned char green, unsigned char blue) {
  Picture picture{.width = width, .height = height, .rgb = {}};
  for (int i = 0; i < width * height; ++i) picture.rgb.insert(picture.rgb.end(), {red, green, blue});
  return picture;
}

TEST(Animations, ShowTheirPicturesInOrderAtTheirRate) {
  const std::string path = ::testing::TempDir() + "gnomon_animation.gif";
  Animation animation(path, 20);
  ASSERT_TRUE(animation.add(plain(24, 10, 250, 0, 0)).ok());
  ASSERT_TRUE(animation.add(plain(24, 10, 0, 250, 0)).ok());
  ASSERT_TRUE(animation.add(plain(24, 10, 0, 0, 250)).ok());
  EXPECT_FALSE(std::filesystem::exists(path)) << "nothing half-written";
  ASSERT_TRUE(animation.write().ok());
  const auto input = OIIO::ImageInput::open(path);
  ASSERT_TRUE(input) << OIIO::geterror();
  for (int picture = 0; picture < 3; ++picture) {
    ASSERT_TRUE(input->seek_subimage(picture, 0)) << input->geterror();
    const OIIO::ImageSpec spec = input->spec();
    EXPECT_EQ(spec.width, 24);
    EXPECT_EQ(spec.height, 10);
    EXPECT_EQ(spec.get_float_attribute("FramesPerSecond"), 20);
    std::vector<unsigned char> pixels(24 * 10 * 4);
    ASSERT_TRUE(input->read_image(picture, 0, 0, spec.nchannels, OIIO::TypeUInt8, pixels.data()));
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(pixels[std::size_t(channel)], channel == picture ? 250 : 0, 8) << picture << " " << channel;
  }
  EXPECT_FALSE(input->seek_subimage(3, 0));
  std::filesystem::remove(path);
}

TEST(Animations, FailWithTheirPath) {
  Animation empty("x.gif", 10);
  EXPECT_EQ(to_string(empty.write().diagnostics().front()),
            "x.gif: error: cannot encode the animation: it has no pictures");
  Animation mixed("y.gif", 10);
  ASSERT_TRUE(mixed.add(plain(4, 4, 1, 2, 3)).ok());
  const Result<Done> other = mixed.add(plain(5, 4, 1, 2, 3));
  ASSERT_FALSE(other.ok());
  EXPECT_EQ(to_string(other.diagnostics().front()),
            "y.gif: error: cannot encode the animation: its pictures differ in size");
  EXPECT_EQ(other.diagnostics().front().failure, Failure::kMachine);
  Animation nowhere(::testing::TempDir() + "gnomon_no_such_folder/z.gif", 10);
  ASSERT_TRUE(nowhere.add(plain(4, 4, 1, 2, 3)).ok());
  EXPECT_FALSE(nowhere.write().ok());
}

}  // namespace
}  // namespace gnomon::image
