// SPDX-License-Identifier: MIT
#include "judge/number_text.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace gnomon::judge {

std::string number_text(double value) {
  // Without the range check the conversion of a larger double would be undefined.
  const bool in_range = std::abs(value) <= double{std::numeric_limits<float>::max()};
  if (in_range && double{static_cast<float>(value)} == value)
    return fmt::format("{}", static_cast<float>(value));
  return fmt::format("{}", value);
}

std::string percent_text(double share) {
  return share == 0 ? "0" : fmt::format("{:.3g} %", 100 * share);
}

}  // namespace gnomon::judge
