// SPDX-License-Identifier: MIT
// The ways to OpenGL that a machine offers, as a user sees them: `gnomon info` lists them, --device picks
// one.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace gnomon::gl {

enum class Api { kEgl, kOsmesa };

/// As on the command line: "egl", "osmesa".
[[nodiscard]] const char* name_of(Api api);

/// One way to a context. What is known of it grows: listing costs little, making a context tells the rest.
struct Device {
  static constexpr int kSurfaceless = -1;

  Api api = Api::kEgl;
  int egl_device = kSurfaceless;  ///< index in eglQueryDevicesEXT, or the surfaceless platform; EGL only
  std::string place;              ///< "EGL device /dev/dri/card0", "EGL surfaceless platform", "OSMesa"
  std::optional<bool> software;   ///< drawn by the CPU; nullopt: not known yet
  std::string renderer;           ///< GL_RENDERER; empty: not known yet
  std::string version;            ///< GL_VERSION; empty: no context was made yet
  std::string failure;            ///< why it gives no context; empty: it does, or was not tried
};

/// What was found. A device's number is its index: EGL's devices in EGL's order, the surfaceless platform,
/// OSMesa.
struct Found {
  std::vector<Device> devices;
  std::string egl_lacks;     ///< what is missing, and which package brings it; empty: nothing
  std::string osmesa_lacks;  ///< likewise
};

/// What the user asked for; by default what `auto` takes.
struct Request {
  std::optional<Api> api{};
  std::string device{};  ///< a number, or a part of a renderer's or place's name in any case; empty: any
};

}  // namespace gnomon::gl
