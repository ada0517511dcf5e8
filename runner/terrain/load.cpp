// SPDX-License-Identifier: MIT
#include "terrain/load.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "image/stored_image.h"

namespace gnomon::terrain {
namespace {

/// Why a sample is no height, or nothing. `stored` is the file's number, `metres` what it came to.
std::optional<std::string> refusal(double stored, double metres) {
  if (std::isnan(stored))
    return "is not a number (NaN marks missing data, which this version does not support; fill the holes "
           "first)";
  if (std::isinf(stored)) return "is infinite; heights must be finite";
  if (!(std::abs(metres) <= kHighestHeight))
    return fmt::format("is {} m high, which is too high for single precision", metres);
  return std::nullopt;
}

Result<HeightMap> to_heights(const std::string& path, const image::StoredImage& image,
                             const LoadOptions& options) {
  HeightMap map;
  map.width = image.width;
  map.height = image.height;
  map.domain_width = image.width;
  map.domain_height = image.height;
  if (options.spacing) {
    map.spacing_x = (*options.spacing)[0];
    map.spacing_y = (*options.spacing)[1];
  }
  map.samples.reserve(image.pixels());
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    const double stored = image.value(i, 0);
    const double metres = stored * options.vertical_scale;
    if (const auto why = refusal(stored, metres)) {
      const auto width = static_cast<std::size_t>(image.width);
      return Diagnostic{
          .file = path,
          .message = fmt::format("the sample in column {}, row {} (counted from 0 in the north-west) {}",
                                 i % width, i / width, *why)};
    }
    map.samples.push_back(static_cast<float>(metres));
  }
  return map;
}

}  // namespace

Result<LoadedHeightMap> load_height_map(const std::string& path, const LoadOptions& options) {
  const auto image = image::read_stored(
      path, {.max_size = options.max_size, .one_channel = true, .channel = options.channel});
  if (!image) return image.diagnostics();
  auto map = to_heights(path, *image, options);
  if (!map) return map.diagnostics();
  LoadedHeightMap loaded{std::move(*map), {}};
  if (!options.spacing) loaded.notes.emplace_back("no spacing is given: 1 m between samples is assumed");
  return loaded;
}

}  // namespace gnomon::terrain
