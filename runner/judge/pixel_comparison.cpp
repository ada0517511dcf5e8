// SPDX-License-Identifier: MIT
#include "judge/pixel_comparison.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace gnomon::judge {
namespace {

std::set<std::string> compared_channels(const image::Image& expected, const CompareOptions& options) {
  if (!options.channels.empty()) return options.channels;
  std::set<std::string> names;
  for (const auto& [name, values] : expected.channels) {
    const bool skipped = name == "band" || (name == "steps" && !options.tolerance.contains(name));
    if (!skipped) names.insert(name);
  }
  return names;
}

double tolerance_of(const std::string& channel, const CompareOptions& options) {
  const auto named = options.tolerance.find(channel);
  return named == options.tolerance.end() ? options.default_tolerance : named->second;
}

}  // namespace

std::optional<Obstacle> not_finite(const image::Image& image) {
  for (const auto& [name, values] : image.channels) {
    const auto found =
        std::find_if_not(values.begin(), values.end(), [](float v) { return std::isfinite(v); });
    if (found == values.end()) continue;
    const auto pixel = std::distance(values.begin(), found);
    const auto width = std::max(image.width, 1);
    return Obstacle{fmt::format("{} is not finite at ({}, {})", name, pixel % width, pixel / width),
                    "finite values"};
  }
  return std::nullopt;
}

Obstacle lacks_channel(const image::Image& image, const std::string& name) {
  std::vector<std::string> names;
  for (const auto& channel : image.channels) names.push_back(channel.first);
  return {fmt::format("no channel {} (there {} {})", name, names.size() == 1 ? "is" : "are",
                      names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))),
          fmt::format("channel {}", name)};
}

std::optional<Obstacle> not_comparable(const image::Image& actual, const image::Image& expected,
                                       const CompareOptions& options) {
  const std::set<std::string> names = compared_channels(expected, options);
  if (expected.pixels() == 0 || names.empty()) {
    return Obstacle{"the expected image holds nothing to compare", "at least one pixel and one channel"};
  }
  if (actual.width != expected.width || actual.height != expected.height) {
    return Obstacle{fmt::format("{}x{} pixels", actual.width, actual.height),
                    fmt::format("{}x{} pixels", expected.width, expected.height)};
  }
  for (const std::string& name : names) {
    if (expected.channel(name) == nullptr) {
      Obstacle obstacle = lacks_channel(expected, name);
      obstacle.measured = "in the expected image " + obstacle.measured;
      return obstacle;
    }
    if (actual.channel(name) == nullptr) return lacks_channel(actual, name);
  }
  return std::nullopt;
}

PixelComparison::PixelComparison(const image::Image& actual, const image::Image& expected,
                                 const CompareOptions& options)
    : valid_(expected.channel("valid")), band_(options.band ? expected.channel("band") : nullptr) {
  for (const std::string& name : compared_channels(expected, options)) {
    channels_.push_back({name, *actual.channel(name), *expected.channel(name), tolerance_of(name, options)});
  }
}

std::optional<ChannelDifference> PixelComparison::difference(std::size_t pixel) const {
  std::optional<ChannelDifference> worst;
  for (const Channel& channel : channels_) {
    if (!valid(pixel) && channel.name != "valid") continue;
    const double actual = channel.actual[pixel];
    const double expected = channel.expected[pixel];
    const double excess = std::abs(actual - expected) - channel.tolerance;
    if (excess <= 0) continue;  // a NaN is not <= 0: it differs
    if (!worst || excess > worst->excess) worst = ChannelDifference{channel.name, excess, actual, expected};
  }
  return worst;
}

}  // namespace gnomon::judge
