// SPDX-License-Identifier: MIT
// Golden images: what they hold, and when one may be written.
#pragma once

#include <vector>

#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"

namespace gnomon {

/// What a golden is made of and has to agree with.
struct GoldenSource {
  const image::Image& actual;
  const image::Image& reference;       ///< the oracle's answer for the points of `actual`
  const std::vector<float>& unsteady;  ///< see Engine::unsteady
};

/// The golden of a render: b_shadow, k_shadow, valid, q and the band, the oracle's and that of unsteady
/// pixels; the header tells where it comes from.
[[nodiscard]] image::Image make_golden(const GoldenSource& source, const scene::Scene& scene);

/// Writes the golden of the scene, making its folder. Fails (kFailed) if the oracle disagrees outside the
/// band and the scene does not say why (`unproven`).
[[nodiscard]] Result<Done> write_golden(const GoldenSource& source, const scene::Scene& scene,
                                        const scene::GoldenExpectation& expectation);

}  // namespace gnomon
