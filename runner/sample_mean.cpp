// SPDX-License-Identifier: MIT
#include "sample_mean.h"

#include <cmath>

namespace gnomon {

glm::dvec2 sample_offset(int sample) {
  constexpr double kPlastic = 1.32471795724474602596;  // the real root of x^3 = x + 1
  const auto offset = [&](double step) {
    const double at = 0.5 + (sample + 1) * step;
    return at - std::floor(at) - 0.5;
  };
  return {offset(1 / kPlastic), offset(1 / (kPlastic * kPlastic))};
}

SampleMean::SampleMean(std::size_t pixels) : seen_(pixels) {
  for (const char* name : {"k_shadow", "R", "G", "B"}) sums_[name].resize(pixels);
}

void SampleMean::add(const image::Image& sample) {
  ++samples_;
  const std::vector<float>& valid = sample.channels.at("valid");
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    if (valid[i] == 0) continue;
    ++seen_[i];
    for (auto& [name, sum] : sums_) sum[i] += double{sample.channels.at(name)[i]};
  }
}

void SampleMean::store(image::Image& image) const {
  std::vector<float>& coverage = image.channels["coverage"];
  coverage.resize(seen_.size());
  for (const auto& [name, sum] : sums_) image.channels[name].resize(seen_.size());
  for (std::size_t i = 0; i < seen_.size(); ++i) {
    coverage[i] = static_cast<float>(seen_[i] / samples_);
    for (const auto& [name, sum] : sums_) {
      const bool is_factor = name == "k_shadow";
      const double mean = is_factor ? (seen_[i] > 0 ? sum[i] / seen_[i] : 1.0) : sum[i] / samples_;
      image.channels[name][i] = static_cast<float>(mean);
    }
  }
}

}  // namespace gnomon
