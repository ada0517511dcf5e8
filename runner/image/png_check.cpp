// SPDX-License-Identifier: MIT
#include "image/png_check.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>

namespace gnomon::image {
namespace {

constexpr std::streamoff kSignatureBytes = 8;
constexpr const char* kTruncated = "the PNG file ends before its image does; it is truncated";

std::uint32_t big_endian(const unsigned char* bytes) {
  return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 | std::uint32_t{bytes[2]} << 8 |
         bytes[3];
}

bool read(std::ifstream& file, unsigned char* bytes, std::size_t count) {
  return static_cast<bool>(file.read(reinterpret_cast<char*>(bytes), static_cast<std::streamsize>(count)));
}

/// The IHDR chunk's size, and for grey images its bit depth (palettes of fewer bits are widened to colours).
std::optional<std::string> header_defect(const std::array<unsigned char, 13>& header, int max_size) {
  const std::uint32_t width = big_endian(&header[0]), height = big_endian(&header[4]);
  if (width > static_cast<std::uint32_t>(max_size) || height > static_cast<std::uint32_t>(max_size))
    return fmt::format("the image has {} x {} samples; the limit is {} on each side", width, height,
                       max_size);
  constexpr unsigned char kGrey = 0;
  const unsigned char bits = header[8], colour_type = header[9];
  if (colour_type == kGrey && bits < 8)
    return fmt::format("the image has {} bits a sample; convert it to 8 or 16", bits);
  return std::nullopt;
}

/// Reads the `length` bytes of a chunk and the checksum over its name and data that follows them.
std::optional<std::string> data_defect(std::ifstream& file, const std::string& name, std::uint32_t length) {
  uLong checksum = crc32(0, reinterpret_cast<const Bytef*>(name.data()), 4);
  std::array<unsigned char, 65536> part;
  for (std::uint32_t left = length; left > 0;) {
    const auto count = std::min<std::uint32_t>(left, part.size());
    if (!read(file, part.data(), count)) return kTruncated;
    checksum = crc32(checksum, part.data(), count);
    left -= count;
  }
  if (!read(file, part.data(), 4)) return kTruncated;
  if (big_endian(part.data()) != checksum)
    return fmt::format("the PNG file is damaged: the checksum of its chunk {} does not fit", name);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> png_defect(const std::string& path, int max_size) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(kSignatureBytes);
  for (bool first = true;; first = false) {
    std::array<unsigned char, 8> start;
    if (!read(file, start.data(), start.size())) return kTruncated;
    const std::uint32_t length = big_endian(start.data());
    const std::string name(start.begin() + 4, start.end());
    if (first) {
      std::array<unsigned char, 13> header;
      if (name != "IHDR" || length != header.size())
        return "the PNG file is damaged: it does not begin with a header";
      if (!read(file, header.data(), header.size())) return kTruncated;
      if (auto defect = header_defect(header, max_size)) return defect;
      file.seekg(-static_cast<std::streamoff>(header.size()), std::ios::cur);
    }
    if (auto defect = data_defect(file, name, length)) return defect;
    if (name == "IEND") return std::nullopt;
  }
}

}  // namespace gnomon::image
