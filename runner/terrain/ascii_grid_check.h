// SPDX-License-Identifier: MIT
// What GDAL overlooks in an ESRI ASCII grid: it reads words as 0 and leaves surplus numbers out. Internal to
// this folder.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

namespace gnomon::terrain {

/// Why the file does not hold exactly `count` numbers after its header, or nothing.
[[nodiscard]] std::optional<std::string> ascii_grid_defect(const std::string& path, std::size_t count);

}  // namespace gnomon::terrain
