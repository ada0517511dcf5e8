// SPDX-License-Identifier: MIT
#include "image/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "gnomon/atomic_file.h"
#include "image/stored_image.h"

namespace gnomon::image {
namespace {

Diagnostic cannot_write(const std::string& path, std::string message) {
  return {.file = path, .message = std::move(message), .failure = Failure::kMachine};
}

/// Encodes in memory, so that the file itself is written by one atomic function whatever its format.
Result<std::vector<unsigned char>> encode(const std::string& path, const char* format,
                                          const OIIO::ImageSpec& spec, const void* pixels) {
  std::vector<unsigned char> bytes;
  try {
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create(format);
    if (!output)
      return cannot_write(path, fmt::format("OpenImageIO was built without its {} writer", format));
    const bool encoded = output->set_ioproxy(&memory) && output->open(path, spec) &&
                         output->write_image(spec.format, pixels) && output->close();
    if (!encoded) return cannot_write(path, fmt::format("cannot encode the image: {}", output->geterror()));
  } catch (const std::exception& error) {
    return cannot_write(path, fmt::format("cannot encode the image: {}", error.what()));
  }
  return bytes;
}

Result<Done> encode_and_write(const std::string& path, const char* format, const OIIO::ImageSpec& spec,
                              const void* pixels) {
  const auto bytes = encode(path, format, spec, pixels);
  if (!bytes) return bytes.diagnostics();
  return write_file_atomically(path, std::as_bytes(std::span(*bytes)));
}

/// What keeps a caller's image from being written: no pixels, a channel of another size, a value that is not
/// finite.
std::optional<Diagnostic> check_channel(const std::string& path, const Image& image,
                                        const std::string& name) {
  const std::vector<float>& values = image.channels.at(name);
  if (image.width < 1 || image.height < 1 || values.size() != image.pixels())
    return cannot_write(path, fmt::format("channel '{}' has {} values for {} x {} pixels", name,
                                          values.size(), image.width, image.height));
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) {
      const auto width = static_cast<std::size_t>(image.width);
      return cannot_write(
          path, fmt::format("channel '{}' holds {} at pixel ({}, {}); only finite values are written", name,
                            values[i], i % width, i / width));
    }
  return std::nullopt;
}

OIIO::ImageSpec float_spec(const Image& image, int channels) {
  OIIO::ImageSpec spec(image.width, image.height, channels, OIIO::TypeFloat);
  spec.attribute("compression", "zip");
  // OpenImageIO would put in the time of day, and equal images would differ.
  spec.attribute("DateTime", "");
  return spec;
}

}  // namespace

Result<Image> read_image(const std::string& path) {
  const Result<StoredImage> stored = read_stored(path, {});
  if (!stored) return stored.diagnostics();
  Image image;
  image.width = stored->width;
  image.height = stored->height;
  image.attributes = stored->attributes;
  for (std::size_t c = 0; c < stored->channels.size(); ++c) {
    std::vector<float>& values = image.channels[stored->channels[c]];
    values.reserve(image.pixels());
    for (std::size_t i = 0; i < image.pixels(); ++i)
      values.push_back(static_cast<float>(stored->value(i, c)));
  }
  return image;
}

Result<Done> write_exr(const std::string& path, const Image& image) {
  if (image.channels.empty()) return cannot_write(path, "the image has no channels");
  OIIO::ImageSpec spec = float_spec(image, static_cast<int>(image.channels.size()));
  spec.channelnames.clear();
  for (const auto& [name, values] : image.channels) {
    if (auto refusal = check_channel(path, image, name)) return *std::move(refusal);
    spec.channelnames.push_back(name);
  }
  for (const auto& [name, value] : image.attributes) spec.attribute(name, value);

  std::vector<float> interleaved;
  interleaved.reserve(image.pixels() * image.channels.size());
  for (std::size_t i = 0; i < image.pixels(); ++i)
    for (const auto& [name, values] : image.channels) interleaved.push_back(values[i]);
  return encode_and_write(path, "openexr", spec, interleaved.data());
}

Result<Done> write_png(const std::string& path, const Picture& picture) {
  const auto pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  if (picture.width < 1 || picture.height < 1 || picture.rgb.size() != 3 * pixels)
    return cannot_write(path, fmt::format("the picture has {} bytes for {} x {} pixels of 3",
                                          picture.rgb.size(), picture.width, picture.height));
  const OIIO::ImageSpec spec(picture.width, picture.height, 3, OIIO::TypeUInt8);
  return encode_and_write(path, "png", spec, picture.rgb.data());
}

}  // namespace gnomon::image
