// SPDX-License-Identifier: MIT
#include "report/picture_link.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string_view>

namespace gnomon::report {
namespace {

/// RFC 3986, with "/" left as it is.
std::string percent_encoded(const std::string& path) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string link;
  for (const char c : path) {
    link += kPlain.find(c) != std::string_view::npos ? std::string(1, c)
                                                     : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return link;
}

struct PngSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

/// The size lies at a fixed place of a PNG file (signature, length and name of IHDR, width, height): no need
/// to decode it.
std::optional<PngSize> png_size(const std::string& file) {
  constexpr std::string_view kStart("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
  std::array<char, 24> header{};
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(header.data(), header.size()) ||
      !std::string_view(header.data(), header.size()).starts_with(kStart)) {
    return std::nullopt;
  }
  const auto big_endian = [&](std::size_t first) {
    std::uint32_t value = 0;
    for (std::size_t i = first; i < first + 4; ++i)
      value = value << 8U | static_cast<unsigned char>(header[i]);
    return value;
  };
  const PngSize size{big_endian(16), big_endian(20)};
  return size.width > 0 && size.height > 0 ? std::optional(size) : std::nullopt;
}

}  // namespace

std::string link_to(const std::string& file, const std::string& directory) {
  namespace fs = std::filesystem;
  const fs::path relative =
      fs::path(file).lexically_normal().lexically_relative(fs::path(directory).lexically_normal());
  return percent_encoded(relative.empty() ? file : relative.generic_string());
}

std::optional<ShownSize> shown_size(const std::string& png_file) {
  constexpr double kLongestSide = 360;  // three of them fit side by side
  const std::optional<PngSize> size = png_size(png_file);
  if (!size) return std::nullopt;
  const double room = kLongestSide / std::max(size->width, size->height);
  const double scale = room >= 1 ? std::floor(room) : room;
  const auto shown = [&](std::uint32_t side) {
    return std::max(1, static_cast<int>(std::lround(scale * side)));
  };
  return ShownSize{shown(size->width), shown(size->height), room >= 1};
}

}  // namespace gnomon::report
