// SPDX-License-Identifier: MIT
// A headless OpenGL context. Everything else in gl/ needs one that is current and outlives it.
#pragma once

#include <memory>
#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon::gl {

/// What the driver says of itself.
struct Info {
  std::string backend;           ///< "egl (surfaceless)"
  std::string vendor;            ///< GL_VENDOR
  std::string renderer;          ///< GL_RENDERER
  std::string version;           ///< GL_VERSION
  std::string shading_language;  ///< GL_SHADING_LANGUAGE_VERSION
  std::string egl;               ///< EGL_VERSION and EGL_VENDOR
  int max_texture_size = 0;      ///< texels a side
};

/// Move-only owner of an EGL display and an OpenGL 4.5 core context without a surface, current on the thread
/// that made it.
class Context {
 public:
  /// Fails with Failure::kMachine, saying what is missing and which package brings it.
  [[nodiscard]] static Result<Context> create();

  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();

  [[nodiscard]] const Info& info() const;

 private:
  struct State;
  explicit Context(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gnomon::gl
