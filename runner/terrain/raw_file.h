// SPDX-License-Identifier: MIT
// Files of numbers without a header, read by a stated layout. Internal to this folder.
#pragma once

#include <fstream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "terrain/raw_layout.h"

namespace gnomon::terrain {

class RawFile {
 public:
  /// Fails unless the file is exactly as long as the layout says: a wrong layout is seldom of the right
  /// length.
  [[nodiscard]] static Result<RawFile> open(const std::string& path, const RawLayout& layout);

  /// The next row, the northernmost first.
  [[nodiscard]] std::optional<Diagnostic> read_row(std::span<double> stored);

 private:
  RawFile(std::string path, const RawLayout& layout) : path_(std::move(path)), layout_(layout) {}

  std::string path_;
  RawLayout layout_;
  std::ifstream file_;
  std::vector<char> bytes_{};  ///< of one row
};

}  // namespace gnomon::terrain
