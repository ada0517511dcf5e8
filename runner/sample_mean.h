// SPDX-License-Identifier: MIT
// Several samples a pixel.
#pragma once

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <vector>

#include "image/image.h"

namespace gnomon {

/// Where sample 0, 1, 2, ... of a pixel lies, pixels from its centre: the R2 sequence, spread evenly for any
/// number of samples (M. Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
[[nodiscard]] glm::dvec2 sample_offset(int sample);

/// The means of the channels that anti-aliasing smooths.
class SampleMean {
 public:
  explicit SampleMean(std::size_t pixels);

  /// An image of one sample a pixel with the channels valid, k_shadow, R, G, B.
  void add(const image::Image& sample);

  /// Writes coverage (share of samples that see ground), R, G, B (sky counts as 0) and k_shadow (of the
  /// samples that see ground; 1 where none does).
  void store(image::Image& image) const;

 private:
  double samples_ = 0;
  std::vector<double> seen_;
  std::map<std::string, std::vector<double>> sums_;  ///< over samples that see ground
};

}  // namespace gnomon
