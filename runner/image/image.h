// SPDX-License-Identifier: MIT
// Images with named float channels, and the files they live in (OpenEXR, PNG, TIFF through OpenImageIO).
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::image {

/// Row-major, row 0 on top (north for the map camera). All channels have width * height values.
struct Image {
  int width = 0;
  int height = 0;
  std::map<std::string, std::vector<float>> channels;  ///< by name: b_shadow, k_shadow, q, steps, valid, ...
  std::map<std::string, std::string> attributes;       ///< header strings, such as gnomon:scene; kept by EXR

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  [[nodiscard]] const std::vector<float>* channel(const std::string& name) const {
    const auto it = channels.find(name);
    return it == channels.end() ? nullptr : &it->second;
  }
};

/// Every channel as float, by its own name (OpenImageIO sorts them; order carries no meaning), and string
/// attributes. Integer files (PNG) give the stored numbers. Fails: missing, unreadable, truncated, not an
/// image.
[[nodiscard]] Result<Image> read_image(const std::string& path);

/// Writes all channels as 32-bit float (compression: zip) with the attributes; byte-identical for equal input
/// (no clock, no host name in the header). Atomic: a temporary file beside `path`, renamed at the end; on
/// failure (Failure::kMachine) the older file stays. Fails too if a value is not finite.
[[nodiscard]] Result<Done> write_exr(const std::string& path, const Image& image);

/// An 8-bit RGB picture; rows from the top, 3 bytes a pixel.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<unsigned char> rgb;
};
[[nodiscard]] Result<Done> write_png(const std::string& path, const Picture& picture);

}  // namespace gnomon::image
