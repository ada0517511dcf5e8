// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <array>

#include "judge/judge.h"
#include "judge/number_text.h"
#include "judge/pixel_comparison.h"

namespace gnomon::judge {
namespace {

std::string limit_text(const CompareOptions& options) {
  if (options.min_mismatch > 0) {
    return fmt::format("from {} to {}", percent_text(options.min_mismatch),
                       percent_text(options.max_mismatch));
  }
  return "at most " + percent_text(options.max_mismatch);
}

std::string measured_text(const Verdict& verdict, double share) {
  std::string text = fmt::format("{:.0f} of {:.0f} pixels differ", verdict.mismatches, verdict.compared);
  if (share > 0) text += fmt::format(" ({})", percent_text(share));
  if (verdict.in_band > 0) text += fmt::format("; {:.0f} in the band not counted", verdict.in_band);
  return text;
}

/// Counts the pixels and finds the worst one; the images are comparable.
Verdict count(const image::Image& actual, const image::Image& expected, const CompareOptions& options) {
  const PixelComparison comparison(actual, expected, options);
  Verdict verdict;
  double largest_excess = 0;
  for (std::size_t pixel = 0; pixel < expected.pixels(); ++pixel) {
    const auto difference = comparison.difference(pixel);
    if (!comparison.valid(pixel) && !difference) continue;
    if (comparison.in_band(pixel)) {
      ++verdict.in_band;
      continue;
    }
    ++verdict.compared;
    if (!difference) continue;
    ++verdict.mismatches;
    if (difference->excess <= largest_excess) continue;
    largest_excess = difference->excess;
    const auto width = static_cast<std::size_t>(expected.width);
    verdict.worst = {static_cast<int>(pixel % width), static_cast<int>(pixel / width),
                     std::string(difference->channel), difference->actual, difference->expected};
  }
  return verdict;
}

using Colour = std::array<unsigned char, 3>;
constexpr Colour kDiffers{224, 32, 48};
constexpr Colour kExcused{250, 204, 21};
// Pale, so that the signal colours stand out, single pixels of a large picture too.
constexpr Colour kLit{232, 232, 232};
constexpr Colour kShadow{176, 176, 176};
constexpr Colour kNoSurface{64, 66, 72};

Colour background(const image::Image& expected, std::size_t pixel) {
  const std::vector<float>* b_shadow = expected.channel("b_shadow");
  return b_shadow != nullptr && (*b_shadow)[pixel] != 0 ? kShadow : kLit;
}

}  // namespace

Verdict compare(const image::Image& actual, const image::Image& expected, const CompareOptions& options) {
  std::optional<Obstacle> obstacle = not_finite(actual);
  if (!obstacle) obstacle = not_comparable(actual, expected, options);
  if (!obstacle && (obstacle = not_finite(expected)))
    obstacle->measured = "in the expected image " + obstacle->measured;
  if (obstacle) return {.expectation = "golden", .measured = obstacle->measured, .limit = obstacle->limit};

  Verdict verdict = count(actual, expected, options);
  const double share = verdict.compared > 0 ? verdict.mismatches / verdict.compared : 0;
  verdict.expectation = "golden";
  // A mask over everything proves nothing.
  const bool vacuous = verdict.compared == 0 && verdict.in_band > 0;
  verdict.passed = !vacuous && options.min_mismatch <= share && share <= options.max_mismatch;
  verdict.measured = measured_text(verdict, share);
  verdict.limit = limit_text(options);
  return verdict;
}

image::Picture difference_picture(const image::Image& actual, const image::Image& expected,
                                  const CompareOptions& options) {
  image::Picture picture{.width = expected.width, .height = expected.height, .rgb = {}};
  picture.rgb.reserve(3 * expected.pixels());
  const auto paint = [&](const Colour& colour) {
    picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
  };

  if (not_comparable(actual, expected, options)) {
    for (std::size_t pixel = 0; pixel < expected.pixels(); ++pixel) paint(kDiffers);
    return picture;
  }
  const PixelComparison comparison(actual, expected, options);
  for (std::size_t pixel = 0; pixel < expected.pixels(); ++pixel) {
    if (comparison.difference(pixel)) {
      paint(comparison.in_band(pixel) ? kExcused : kDiffers);
    } else {
      paint(comparison.valid(pixel) ? background(expected, pixel) : kNoSurface);
    }
  }
  return picture;
}

}  // namespace gnomon::judge
