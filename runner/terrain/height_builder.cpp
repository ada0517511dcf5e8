// SPDX-License-Identifier: MIT
#include "terrain/height_builder.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace gnomon::terrain {
namespace {

/// Why a sample is no height, or nothing. `stored` is the file's number, `metres` what it came to.
std::optional<std::string> refusal(double stored, double metres) {
  if (std::isinf(stored)) return "is infinite; heights must be finite, and NaN says that there is no data";
  if (!(std::abs(metres) <= kHighestHeight))
    return fmt::format("is {} m high, which is too high for single precision", metres);
  return std::nullopt;
}

}  // namespace

HeightBuilder::HeightBuilder(std::string path, int width, int height, const Conversion& conversion)
    : path_(std::move(path)), conversion_(conversion) {
  map_.width = width;
  map_.height = height;
  map_.domain_width = width;
  map_.domain_height = height;
  // Reserved, not filled: a large header without data behind it then costs no memory.
  map_.samples.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
}

bool HeightBuilder::is_missing(double stored) const {
  if (std::isnan(stored)) return true;
  if (!conversion_.nodata) return false;
  const bool same_single =
      conversion_.single && static_cast<float>(stored) == static_cast<float>(*conversion_.nodata);
  return stored == *conversion_.nodata || same_single;
}

std::optional<Diagnostic> HeightBuilder::add_row(std::span<const double> stored,
                                                 std::span<const unsigned char> present) {
  for (std::size_t column = 0; column < stored.size(); ++column) {
    if (is_missing(stored[column]) || (!present.empty() && present[column] == 0)) {
      map_.samples.push_back(kNoSample);
      map_.holes = true;
      continue;
    }
    const double metres = (stored[column] * conversion_.scale + conversion_.offset) * conversion_.unit;
    if (const auto why = refusal(stored[column], metres))
      return Diagnostic{
          .file = path_,
          .message = fmt::format("the sample in column {}, row {} (counted from 0 in the north-west) {}",
                                 column, map_.samples.size() / stored.size(), *why)};
    map_.samples.push_back(static_cast<float>(metres));
  }
  return std::nullopt;
}

}  // namespace gnomon::terrain
