// SPDX-License-Identifier: MIT
// EGL without a window: its devices, Mesa's surfaceless platform, and contexts on them. Private to gl/.
#pragma once

#include <string>
#include <vector>

#include "gl/device.h"
#include "gl/native.h"

namespace gnomon::gl {

struct EglListing {
  std::vector<Device> devices;  ///< EGL's devices in EGL's order, then the surfaceless platform
  std::string lacks;            ///< what is missing where there are none, and which package brings it
};

/// Asks for names only where a driver tells them without a context.
[[nodiscard]] EglListing list_egl();

/// What a display's extensions spare: tests open contexts without them, as on drivers that lack them.
struct EglMeans {
  bool no_config = true;    ///< EGL_KHR_no_config_context; else a config is chosen
  bool surfaceless = true;  ///< EGL_KHR_surfaceless_context; else a pixel buffer of 1x1 is made
};

/// An OpenGL 4.5 core context, not current yet. `egl_device` as in Device; uses of `allowed` what there is.
[[nodiscard]] Opened open_egl(int egl_device, EglMeans allowed = {});

}  // namespace gnomon::gl
