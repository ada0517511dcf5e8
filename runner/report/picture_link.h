// SPDX-License-Identifier: MIT
// How a page shows a picture file. Private to the report.
#pragma once

#include <optional>
#include <string>

namespace gnomon::report {

/// `file` as seen from `directory`, percent-encoded: an id's "=", "@" and "#" mean something else in a link.
/// Either both paths are absolute or both relative to the same folder.
[[nodiscard]] std::string link_to(const std::string& file, const std::string& directory);

/// Size on the page, in CSS pixels.
struct ShownSize {
  int width = 0;
  int height = 0;
  bool enlarged_pixels = false;  ///< show every pixel as a square instead of smoothing
};

/// The size at which to show a PNG file: a small one enlarged by a whole number, a large one reduced. Nothing
/// where the file is absent or no PNG.
[[nodiscard]] std::optional<ShownSize> shown_size(const std::string& png_file);

}  // namespace gnomon::report
