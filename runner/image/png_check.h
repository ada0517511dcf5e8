// SPDX-License-Identifier: MIT
// Damage in a PNG file, found before libpng sees it. Internal to this folder.
#pragma once

#include <optional>
#include <string>

namespace gnomon::image {

/// Why a file that begins with the PNG signature cannot be read: larger than max_size, truncated, a checksum
/// that does not fit, a bit depth below 8. Nothing if it is whole. (OpenImageIO leaves libpng's own error
/// messages on, which print; and a size is only known to it once all the chunks before the pixels are there.)
[[nodiscard]] std::optional<std::string> png_defect(const std::string& path, int max_size);

}  // namespace gnomon::image
