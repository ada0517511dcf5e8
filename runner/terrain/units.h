// SPDX-License-Identifier: MIT
// Names of units of length as files write them.
#pragma once

#include <optional>
#include <string_view>

namespace gnomon::terrain {

/// Metres in one unit of this name, in any case; nothing for a name that is unknown or empty.
[[nodiscard]] std::optional<double> metres_per(std::string_view unit);

}  // namespace gnomon::terrain
