// SPDX-License-Identifier: MIT
// An image file as it is stored: numbers untouched, channels by name. What height maps and rendered images
// share.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::image {

/// How the numbers lie in memory; 16-bit floats are widened to 32 on reading.
enum class NumberType { kUint8, kInt8, kUint16, kInt16, kUint32, kInt32, kFloat };

/// The first image of a file, row 0 on top, the channels of a pixel side by side.
struct StoredImage {
  int width = 0;
  int height = 0;
  NumberType type = NumberType::kFloat;
  std::vector<std::string> channels;  ///< those that were read, in the order of `value`
  std::map<std::string, std::string>
      attributes;  ///< header strings, without those that describe the encoding
  std::unique_ptr<std::byte[]> bytes;

  /// The stored number: 0..255 or 0..65535 for integer files, not a share of the largest.
  [[nodiscard]] double value(std::size_t pixel, std::size_t channel) const;
  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
};

struct ReadOptions {
  int max_size = 32768;  ///< longest side that is accepted; a longer one is refused before pixels are read
  bool one_channel = false;            ///< an image of several channels is refused unless `channel` picks one
  std::optional<std::string> channel;  ///< reads this channel only
  bool header_only = false;            ///< leaves `bytes` empty: for the size and the channels alone
};

/// Reads a PNG, OpenEXR or TIFF file, whatever its name ends with. Fails, never throws: missing, a folder,
/// another format, truncated or damaged, larger than max_size, without the channel asked for.
[[nodiscard]] Result<StoredImage> read_stored(const std::string& path, const ReadOptions& options);

}  // namespace gnomon::image
