// SPDX-License-Identifier: MIT
// Which device is taken, and why. Pure: from what was found and what was asked to the answer.
#pragma once

#include <cstddef>
#include <string>

#include "gl/device.h"
#include "gnomon/diagnostic.h"

namespace gnomon::gl {

struct Choice {
  std::size_t device = 0;  ///< index in Found::devices
  std::string reason;      ///< a sentence without its full stop
};

/// The first device, in the order below, that fits the request and has no failure:
/// hardware EGL devices, the surfaceless platform, software EGL devices, OSMesa.
/// Fails with kMachine: what is missing and which package brings it, or which devices there are.
[[nodiscard]] Result<Choice> choose(const Found& found, const Request& request);

/// Whether the request names a device by a text, for which every renderer's name has to be known.
[[nodiscard]] bool asks_by_name(const Request& request);

/// "0 egl: NVIDIA H100, hardware, EGL device /dev/dri/card0", with the failure where there is one.
[[nodiscard]] std::string describe(const Found& found, std::size_t device);

}  // namespace gnomon::gl
