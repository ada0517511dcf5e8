// SPDX-License-Identifier: MIT
// Holds a rendered image against what its scene expects. No GL, no files: images in, verdicts out.
#pragma once

#include <map>
#include <optional>
#include <set>
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
  std::string
      expectation;  ///< "golden", "reference", "reference at level 0", "probe (12, 30)", "max_steps 400"
  bool passed = false;
  std::string measured;  ///< for a person: "9 of 65536 pixels differ (0.0137 %)"
  std::string limit;     ///< for a person: "at most 0"
  std::optional<WorstPixel> worst;
  double mismatches = 0;  ///< compared pixels that differ
  double in_band = 0;     ///< valid pixels that the band kept out of the comparison
  double compared = 0;    ///< valid pixels outside the band
};

/// What the judge may need beside the image. `reference` has the channels b_shadow and band (of the level
/// that the expectation names, or of the image's own); `golden` is absent where the file does not exist.
struct Evidence {
  const image::Image& actual;
  const image::Image* golden = nullptr;
  const image::Image* reference = nullptr;
  std::map<int, const image::Image*> reference_at_level{};  ///< for ReferenceExpectation::level
};

/// One verdict for each expectation, in order. An image with a value that is not finite fails all of them
/// before any metric. A probe is never excused by the band; b_shadow, q and valid must be met exactly, other
/// channels to 1e-6.
[[nodiscard]] std::vector<Verdict> judge(const std::vector<scene::Expectation>& expectations,
                                         const Evidence& evidence);

/// How `gnomon diff` and the golden expectation compare.
struct CompareOptions {
  double max_mismatch = 0;  ///< share of the compared pixels that may differ
  double min_mismatch = 0;  ///< share that must differ: of a method that is known to be wrong
  std::map<std::string, double> tolerance{};  ///< absolute, by channel; a difference equal to it still passes
  double default_tolerance = 0;
  bool band = true;                  ///< the expected image's channel `band` masks pixels
  std::set<std::string> channels{};  ///< the channels to compare; empty: see `compare`
};

/// Compares `actual` with `expected`, pixel by pixel, over the pixels that are valid in `expected` (channel
/// `valid` not 0; all, where it has none) or whose validity differs, and that the band does not mask. A pixel
/// differs if any channel does. Unless the options name channels these are all of `expected` except `band`,
/// and except `steps` without a tolerance of its own: steps may change with every optimisation. Images that
/// differ in size, a value that is not finite in either, and a channel that `actual` lacks do not pass;
/// further channels of `actual` are ignored.
[[nodiscard]] Verdict compare(const image::Image& actual, const image::Image& expected,
                              const CompareOptions& options);

/// Where two images differ, for a person, in the size of `expected`: differing pixels red, those that the
/// band excuses yellow, over a pale expected b_shadow, dark grey where there is no surface. All red
/// where the images cannot be compared (another size, a channel that `actual` lacks).
[[nodiscard]] image::Picture difference_picture(const image::Image& actual, const image::Image& expected,
                                                const CompareOptions& options);

}  // namespace gnomon::judge
