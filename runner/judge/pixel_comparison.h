// SPDX-License-Identifier: MIT
// How two images compare in one pixel. Private to the judge.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "judge/judge.h"

namespace gnomon::judge {

/// Why an expectation cannot be measured at all: what there is, and what was needed.
struct Obstacle {
  std::string measured;
  std::string limit;
};

/// The first value that is not finite: "b_shadow is not finite at (3, 4)".
[[nodiscard]] std::optional<Obstacle> not_finite(const image::Image& image);

/// That `image` has no channel `name`, and which ones it has.
[[nodiscard]] Obstacle lacks_channel(const image::Image& image, const std::string& name);

/// Why the two cannot be compared pixel by pixel: another size, nothing to compare, a channel that one of
/// them lacks.
[[nodiscard]] std::optional<Obstacle> not_comparable(const image::Image& actual, const image::Image& expected,
                                                     const CompareOptions& options);

/// The channel in which a pixel differs most.
struct ChannelDifference {
  std::string_view channel;
  double excess = 0;  ///< beyond the tolerance, > 0
  double actual = 0, expected = 0;
};

/// Looks at single pixels of two comparable images, which must outlive it.
class PixelComparison {
 public:
  PixelComparison(const image::Image& actual, const image::Image& expected, const CompareOptions& options);

  /// Whether there is a surface in the expected image.
  [[nodiscard]] bool valid(std::size_t pixel) const { return valid_ == nullptr || (*valid_)[pixel] != 0; }
  [[nodiscard]] bool in_band(std::size_t pixel) const { return band_ != nullptr && (*band_)[pixel] != 0; }

  /// Nothing where the pixel agrees. Without a surface only its validity is looked at.
  [[nodiscard]] std::optional<ChannelDifference> difference(std::size_t pixel) const;

 private:
  struct Channel {
    std::string name;
    std::span<const float> actual, expected;
    double tolerance;
  };

  std::vector<Channel> channels_;
  const std::vector<float>* valid_;
  const std::vector<float>* band_;
};

}  // namespace gnomon::judge
