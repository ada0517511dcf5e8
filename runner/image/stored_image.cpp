// SPDX-License-Identifier: MIT
#include "image/stored_image.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "image/png_check.h"

namespace gnomon::image {
namespace {

namespace fs = std::filesystem;

/// More than any map or rendered image takes (16384^2, 16 float channels); a damaged header may ask for
/// anything.
constexpr std::uint64_t kMostBytes = 1ull << 35;

Diagnostic unreadable(const std::string& path, std::string message) {
  return {.file = path, .message = std::move(message)};
}

/// OpenImageIO's reader for the format that the file's first bytes announce, whatever its name says; empty
/// for others. (Left to itself OpenImageIO would try all its readers in turn, text and video among them.)
std::string_view reader_for(const std::string& path) {
  using namespace std::string_view_literals;
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> kSignatures{{
      {"\x89PNG\r\n\x1a\n"sv, "png"},
      {"\x76\x2f\x31\x01"sv, "openexr"},
      {"II*\0"sv, "tiff"},
      {"MM\0*"sv, "tiff"},
      {"II+\0"sv, "tiff"},
      {"MM\0+"sv, "tiff"},
  }};
  std::array<char, 8> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  const std::string_view bytes(start.data(), start.size());
  for (const auto& [signature, reader] : kSignatures)
    if (bytes.starts_with(signature)) return reader;
  return {};
}

std::optional<NumberType> number_type(OIIO::TypeDesc type) {
  switch (type.basetype) {
    case OIIO::TypeDesc::UINT8:
      return NumberType::kUint8;
    case OIIO::TypeDesc::INT8:
      return NumberType::kInt8;
    case OIIO::TypeDesc::UINT16:
      return NumberType::kUint16;
    case OIIO::TypeDesc::INT16:
      return NumberType::kInt16;
    case OIIO::TypeDesc::UINT32:
      return NumberType::kUint32;
    case OIIO::TypeDesc::INT32:
      return NumberType::kInt32;
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
      return NumberType::kFloat;
    default:
      return std::nullopt;  // 64-bit floats too: OpenImageIO 2.4 reads those of a TIFF file as 0
  }
}

OIIO::TypeDesc in_memory(OIIO::TypeDesc stored) {
  return stored.basetype == OIIO::TypeDesc::HALF ? OIIO::TypeFloat : stored;
}

/// The channels to read, [begin, end).
struct ChannelRange {
  int begin = 0;
  int end = 0;
};

Result<ChannelRange> choose_channels(const std::string& path, const OIIO::ImageSpec& spec,
                                     const ReadOptions& options) {
  const std::vector<std::string>& names = spec.channelnames;
  if (options.channel && !(options.one_channel && spec.nchannels == 1)) {
    const auto found = std::find(names.begin(), names.end(), *options.channel);
    if (found == names.end())
      return unreadable(path, fmt::format("the image has no channel '{}'; it has {}", *options.channel,
                                          fmt::join(names, ", ")));
    const auto index = static_cast<int>(found - names.begin());
    return ChannelRange{index, index + 1};
  }
  if (options.one_channel && spec.nchannels > 1)
    return unreadable(path,
                      fmt::format("the image has the channels {}; say which one is meant with --channel NAME "
                                  "(\"channel\" in a scene)",
                                  fmt::join(names, ", ")));
  return ChannelRange{0, spec.nchannels};
}

/// Everything that can be refused from the header alone, before memory is taken for the pixels.
std::optional<Diagnostic> check_header(const std::string& path, const OIIO::ImageSpec& spec,
                                       ChannelRange channels, int max_size) {
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep)
    return unreadable(path, "the file holds no flat, two-dimensional image");
  if (spec.width > max_size || spec.height > max_size)
    return unreadable(path, fmt::format("the image has {} x {} samples; the limit is {} on each side",
                                        spec.width, spec.height, max_size));
  const OIIO::TypeDesc type = spec.channelformat(channels.begin);
  if (!number_type(type))
    return unreadable(path,
                      fmt::format("the image's numbers are of type {}; integers of up to 32 bits and floats "
                                  "of 16 or 32 are read",
                                  type.c_str()));
  for (int c = channels.begin; c < channels.end; ++c)
    if (in_memory(spec.channelformat(c)) != in_memory(type))
      return unreadable(path, "the channels are of kinds that cannot be read together; pick one of them");
  const int bits = spec.get_int_attribute("oiio:BitsPerSample", 8 * static_cast<int>(type.size()));
  if (bits != 8 * static_cast<int>(type.size()))
    return unreadable(path, fmt::format("the image has {} bits a sample; convert it to 8 or 16", bits));
  constexpr int kMinIsWhite = 0;  // OpenImageIO would turn the numbers round
  if (spec.get_int_attribute("tiff:PhotometricInterpretation", -1) == kMinIsWhite)
    return unreadable(path, "the TIFF file calls its smallest number white; convert it to MinIsBlack");
  const auto bytes = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) *
                     static_cast<std::uint64_t>(channels.end - channels.begin) * in_memory(type).size();
  if (bytes > kMostBytes)
    return unreadable(path, fmt::format("the pixels would take {} GiB of memory; the limit is {}",
                                        bytes >> 30, kMostBytes >> 30));
  return std::nullopt;
}

std::map<std::string, std::string> string_attributes(const OIIO::ImageSpec& spec) {
  std::map<std::string, std::string> attributes;
  for (const OIIO::ParamValue& attribute : spec.extra_attribs) {
    const std::string name = attribute.name().string();
    const bool about_encoding =
        name.starts_with("oiio:") || name == "compression" || name == "planarconfig" || name == "DateTime";
    if (attribute.type() == OIIO::TypeString && !about_encoding) attributes[name] = attribute.get_string();
  }
  return attributes;
}

/// The first line of what OpenImageIO has to say.
std::string reason(const OIIO::ImageInput& input) {
  const std::string text = input.geterror();
  return text.empty() ? "no reason given" : text.substr(0, text.find('\n'));
}

/// The same as OIIO::ImageInput::read_image, for the strips of a TIFF file. Given several of them at once,
/// OpenImageIO 2.4 unpacks them itself and overlooks damaged ones; given one row, it leaves that to libtiff.
bool read_rows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, ChannelRange channels,
               OIIO::TypeDesc type, std::byte* bytes) {
  const int numbers = spec.width * (channels.end - channels.begin);
  std::vector<std::byte> stored(static_cast<std::size_t>(numbers) * spec.format.size());
  for (int y = spec.y; y < spec.y + spec.height; ++y) {
    if (!input.read_native_scanlines(0, 0, y, y + 1, 0, channels.begin, channels.end, stored.data()))
      return false;
    OIIO::convert_pixel_values(spec.format, stored.data(), type, bytes, numbers);
    bytes += static_cast<std::size_t>(numbers) * type.size();
  }
  return true;
}

bool read_pixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, ChannelRange channels,
                 OIIO::TypeDesc type, std::byte* bytes) {
  const bool in_strips = std::string_view(input.format_name()) == "tiff" && spec.tile_width == 0;
  return in_strips ? read_rows(input, spec, channels, type, bytes)
                   : input.read_image(0, 0, channels.begin, channels.end, type, bytes);
}

Result<StoredImage> read_with(OIIO::ImageInput& input, const std::string& path, const ReadOptions& options) {
  OIIO::ImageSpec keep_numbers;
  keep_numbers.attribute("oiio:UnassociatedAlpha", 1);  // without it, colours are multiplied by alpha
  OIIO::ImageSpec spec;
  if (!input.open(path, spec, keep_numbers))
    return unreadable(path, fmt::format("the image cannot be opened: {}", reason(input)));
  const Result<ChannelRange> chosen = choose_channels(path, spec, options);
  if (!chosen) return chosen.diagnostics();
  const ChannelRange channels = *chosen;
  if (auto refusal = check_header(path, spec, channels, options.max_size)) return *std::move(refusal);

  StoredImage image;
  image.width = spec.width;
  image.height = spec.height;
  image.channels.assign(spec.channelnames.begin() + channels.begin, spec.channelnames.begin() + channels.end);
  image.attributes = string_attributes(spec);
  const OIIO::TypeDesc type = in_memory(spec.channelformat(channels.begin));
  image.type = *number_type(type);
  if (options.header_only) return image;
  // Not zeroed: a large header without data then costs no memory.
  image.bytes =
      std::make_unique_for_overwrite<std::byte[]>(image.pixels() * image.channels.size() * type.size());
  const bool read = read_pixels(input, spec, channels, type, image.bytes.get());
  if (!read || input.has_error())
    return unreadable(path, fmt::format("the image is damaged or incomplete: {}", reason(input)));
  return image;
}

template <class Number>
double number_at(const std::byte* bytes, std::size_t index) {
  Number number;
  std::memcpy(&number, bytes + index * sizeof(Number), sizeof(Number));
  return static_cast<double>(number);
}

}  // namespace

double StoredImage::value(std::size_t pixel, std::size_t channel) const {
  const std::size_t index = pixel * channels.size() + channel;
  switch (type) {
    case NumberType::kUint8:
      return number_at<std::uint8_t>(bytes.get(), index);
    case NumberType::kInt8:
      return number_at<std::int8_t>(bytes.get(), index);
    case NumberType::kUint16:
      return number_at<std::uint16_t>(bytes.get(), index);
    case NumberType::kInt16:
      return number_at<std::int16_t>(bytes.get(), index);
    case NumberType::kUint32:
      return number_at<std::uint32_t>(bytes.get(), index);
    case NumberType::kInt32:
      return number_at<std::int32_t>(bytes.get(), index);
    case NumberType::kFloat:
      return number_at<float>(bytes.get(), index);
  }
  return 0.0;
}

Result<StoredImage> read_stored(const std::string& path, const ReadOptions& options) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) return unreadable(path, "there is no such file");
  if (!fs::is_regular_file(status))
    return unreadable(path, "this is a folder or a device, not an image file");
  if (!std::ifstream(path).good())
    return unreadable(path, "the file cannot be opened; are you allowed to read it?");
  const std::string_view reader = reader_for(path);
  if (reader.empty())
    return unreadable(path, "this is not an image: only PNG, OpenEXR and TIFF files are read");
  if (reader == "png")
    if (auto defect = png_defect(path, options.max_size)) return unreadable(path, *std::move(defect));
  try {
    const auto input = OIIO::ImageInput::create(std::string(reader));
    if (!input) return unreadable(path, fmt::format("OpenImageIO was built without its {} reader", reader));
    return read_with(*input, path, options);
  } catch (const std::exception& error) {
    return unreadable(path, fmt::format("the image cannot be read: {}", error.what()));
  }
}

}  // namespace gnomon::image
