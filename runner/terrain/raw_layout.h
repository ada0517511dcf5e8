// SPDX-License-Identifier: MIT
// How numbers lie in a file without a header ("raw"), as the person who has the file states it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <utility>

namespace gnomon::terrain {

enum class RawType { kUint8, kInt8, kUint16, kInt16, kUint32, kInt32, kFloat32, kFloat64 };

inline constexpr std::array<std::pair<std::string_view, RawType>, 8> kRawTypes{
    {{"uint8", RawType::kUint8},
     {"int8", RawType::kInt8},
     {"uint16", RawType::kUint16},
     {"int16", RawType::kInt16},
     {"uint32", RawType::kUint32},
     {"int32", RawType::kInt32},
     {"float32", RawType::kFloat32},
     {"float64", RawType::kFloat64}}};

[[nodiscard]] inline std::optional<RawType> raw_type(std::string_view name) {
  for (const auto& [known, type] : kRawTypes)
    if (known == name) return type;
  return std::nullopt;
}

[[nodiscard]] inline std::string_view name_of(RawType type) {
  return kRawTypes[static_cast<std::size_t>(type)].first;  // in the order of the enumeration
}

/// Width * height numbers after `skip` bytes, the north row first, each row from west to east, nothing after
/// them.
struct RawLayout {
  int width = 0;   ///< 1..16384
  int height = 0;  ///< 1..16384
  RawType type = RawType::kInt16;
  bool big_endian = false;
  std::uint64_t skip = 0;  ///< bytes
  friend bool operator==(const RawLayout&, const RawLayout&) = default;
};

}  // namespace gnomon::terrain
