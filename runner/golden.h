// SPDX-License-Identifier: MIT
// Golden images: what they hold, and when one may be written.
#pragma once

#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"

namespace gnomon {

/// The golden of a render: b_shadow, k_shadow, valid, q and the oracle's band; the header tells where it
/// comes from.
[[nodiscard]] image::Image make_golden(const image::Image& actual, const image::Image& reference,
                                       const scene::Scene& scene);

/// Writes the golden of the scene, making its folder. Fails (kFailed) if the oracle disagrees outside the
/// band and the scene does not say why (`unproven`).
[[nodiscard]] Result<Done> write_golden(const image::Image& actual, const image::Image& reference,
                                        const scene::Scene& scene,
                                        const scene::GoldenExpectation& expectation);

}  // namespace gnomon
