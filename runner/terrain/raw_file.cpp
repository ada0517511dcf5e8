// SPDX-License-Identifier: MIT
#include "terrain/raw_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>

namespace gnomon::terrain {
namespace {

template <class Number>
double number_at(const char* bytes, bool swap) {
  std::array<char, sizeof(Number)> ordered;
  std::memcpy(ordered.data(), bytes, sizeof(Number));
  if (swap) std::reverse(ordered.begin(), ordered.end());
  Number number;
  std::memcpy(&number, ordered.data(), sizeof(Number));
  return static_cast<double>(number);
}

struct Decoder {
  std::size_t size;
  double (*number)(const char*, bool);
};

template <class Number>
constexpr Decoder kDecoder{sizeof(Number), number_at<Number>};

Decoder decoder_of(RawType type) {
  switch (type) {
    case RawType::kUint8:
      return kDecoder<std::uint8_t>;
    case RawType::kInt8:
      return kDecoder<std::int8_t>;
    case RawType::kUint16:
      return kDecoder<std::uint16_t>;
    case RawType::kInt16:
      return kDecoder<std::int16_t>;
    case RawType::kUint32:
      return kDecoder<std::uint32_t>;
    case RawType::kInt32:
      return kDecoder<std::int32_t>;
    case RawType::kFloat32:
      return kDecoder<float>;
    case RawType::kFloat64:
      return kDecoder<double>;
  }
  return kDecoder<std::uint8_t>;
}

Diagnostic unreadable(const std::string& path, std::string message) {
  return {.file = path, .message = std::move(message)};
}

}  // namespace

Result<RawFile> RawFile::open(const std::string& path, const RawLayout& layout) {
  const std::size_t size = decoder_of(layout.type).size;
  const auto row = static_cast<std::size_t>(layout.width) * size;
  const std::uint64_t heights = row * static_cast<std::uint64_t>(layout.height);
  std::error_code error;
  const std::uint64_t length = std::filesystem::file_size(path, error);
  if (error) return unreadable(path, "the file's length cannot be asked for: " + error.message());
  if (length < layout.skip || length - layout.skip != heights)
    return unreadable(
        path,
        fmt::format("the file has {} bytes, the stated layout wants {}: {} x {} numbers of {} bytes ({}) "
                    "after {} skipped bytes; state another size, type or number of bytes to skip",
                    length, heights + layout.skip, layout.width, layout.height, size, name_of(layout.type),
                    layout.skip));
  RawFile raw(path, layout);
  raw.file_.open(path, std::ios::binary);
  if (!raw.file_.seekg(static_cast<std::streamoff>(layout.skip)))
    return unreadable(path, "the file cannot be opened; are you allowed to read it?");
  raw.bytes_.resize(row);
  return raw;
}

std::optional<Diagnostic> RawFile::read_row(std::span<double> stored) {
  if (!file_.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size())))
    return unreadable(path_, "the file ends before its last height: it changed while it was read");
  const Decoder decoder = decoder_of(layout_.type);
  constexpr bool kMachineIsBig = std::endian::native == std::endian::big;
  for (std::size_t i = 0; i < stored.size(); ++i)
    stored[i] = decoder.number(&bytes_[i * decoder.size], layout_.big_endian != kMachineIsBig);
  return std::nullopt;
}

}  // namespace gnomon::terrain
