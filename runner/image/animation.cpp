// SPDX-License-Identifier: MIT
#include "image/animation.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "gnomon/atomic_file.h"

namespace gnomon::image {
namespace {

OIIO::ImageSpec spec_of(const Picture& picture, double rate) {
  OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeUInt8);
  // The writer turns the ratio into whole hundredths of a second.
  const int hundredths = static_cast<int>(std::lround(100.0 / rate));
  const int ratio[2] = {100, hundredths};
  spec.attribute("FramesPerSecond", OIIO::TypeRational, ratio);
  return spec;
}

}  // namespace

struct Animation::Encoder {
  std::string path;
  double rate;
  std::vector<unsigned char> bytes{};
  OIIO::Filesystem::IOVecOutput memory{bytes};
  std::unique_ptr<OIIO::ImageOutput> output{};
  int width = 0;
  int height = 0;

  [[nodiscard]] Diagnostic failure(const std::string& message) const {
    return {.file = path, .message = "cannot encode the animation: " + message, .failure = Failure::kMachine};
  }

  Result<Done> open(const Picture& picture) {
    const OIIO::ImageSpec spec = spec_of(picture, rate);
    if (output) {
      if (picture.width != width || picture.height != height) return failure("its pictures differ in size");
      if (!output->open(path, spec, OIIO::ImageOutput::AppendSubimage)) return failure(output->geterror());
      return Done{};
    }
    output = OIIO::ImageOutput::create("gif");
    if (!output) return failure("OpenImageIO was built without its gif writer");
    width = picture.width;
    height = picture.height;
    if (!output->set_ioproxy(&memory) || !output->open(path, spec)) return failure(output->geterror());
    return Done{};
  }
};

Animation::Animation(std::string path, double rate)
    : encoder_(std::make_unique<Encoder>(std::move(path), rate)) {}
Animation::Animation(Animation&&) noexcept = default;
Animation& Animation::operator=(Animation&&) noexcept = default;
Animation::~Animation() = default;

Result<Done> Animation::add(const Picture& picture) {
  try {
    if (const Result<Done> opened = encoder_->open(picture); !opened) return opened;
    if (!encoder_->output->write_image(OIIO::TypeUInt8, picture.rgb.data()))
      return encoder_->failure(encoder_->output->geterror());
  } catch (const std::exception& error) {
    return encoder_->failure(error.what());
  }
  return Done{};
}

Result<Done> Animation::write() {
  if (!encoder_->output) return encoder_->failure("it has no pictures");
  if (!encoder_->output->close()) return encoder_->failure(encoder_->output->geterror());
  return write_file_atomically(encoder_->path, std::as_bytes(std::span(encoder_->bytes)));
}

}  // namespace gnomon::image
