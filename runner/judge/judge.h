// SPDX-License-Identifier: MIT
// Holds a rendered image against what its scene expects. No GL, no files: images in, verdicts out.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "image/image.h"
#include "scene/scene.h"

namespace gnomon::judge {

/// The pixel in which an expectation is hurt most.
struct WorstPixel {
  int x = 0, y = 0;
  std::string channel;
  double actual = 0, expected = 0;
};

/// What one expectation came to.
struct Verdict {
  std::string expectation;  ///< "golden", "reference", "probe (12, 30)", "max_steps 400"
  bool passed = false;
  std::string measured;  ///< for a person: "9 of 65536 pixels differ (0.0137 %)"
  std::string limit;     ///< for a person: "at most 0"
  std::optional<WorstPixel> worst;
  double mismatches = 0;  ///< pixels that differ outside the band
  double in_band = 0;     ///< pixels that the band excused from the count
  double compared = 0;    ///< valid pixels outside the band
};

/// What the judge may need beside the image. `reference` has the channels b_shadow, horizon, band (of the level that
/// the expectation names, or of the image's own); `golden` is absent where the file does not exist.
struct Evidence {
  const image::Image& actual;
  const image::Image* golden = nullptr;
  const image::Image* reference = nullptr;
  std::map<int, const image::Image*> reference_at_level;  ///< for ReferenceExpectation::level
};

/// One verdict for each expectation, in order. A pixel whose value is not finite fails before any metric.
[[nodiscard]] std::vector<Verdict> judge(const std::vector<scene::Expectation>& expectations, const Evidence& evidence);

/// How `gnomon diff` and the golden expectation compare.
struct CompareOptions {
  double max_mismatch = 0;                  ///< share of valid pixels outside the band that may differ
  std::map<std::string, double> tolerance;  ///< absolute, by channel
  double default_tolerance = 0;
  bool band = true;  ///< the expected image's channel `band` masks pixels
};

/// Compares every channel of `expected` (except `band`) with that of `actual`. Images that differ in size, or a channel
/// that `actual` lacks, do not pass. Further channels of `actual` are ignored.
[[nodiscard]] Verdict compare(const image::Image& actual, const image::Image& expected, const CompareOptions& options);

/// Where two images differ, for a person: differing pixels red, in-band ones yellow, over a dimmed expected b_shadow.
[[nodiscard]] image::Picture difference_picture(const image::Image& actual, const image::Image& expected,
                                                const CompareOptions& options);

}  // namespace gnomon::judge
