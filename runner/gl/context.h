// SPDX-License-Identifier: MIT
// A headless OpenGL context on the device that was asked for. Everything else in gl/ needs one that is
// current and outlives it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gl/device.h"
#include "gnomon/diagnostic.h"

namespace gnomon::gl {

struct Limit {
  std::string what;  ///< with its unit: "image, pixels a side"
  long value = 0;
};

/// What was chosen, and what the driver says of itself.
struct Info {
  Device device;
  std::size_t number = 0;        ///< of the device, as --device takes it
  std::string reason;            ///< why this one: a sentence without its full stop
  std::string library;           ///< "EGL 1.5, Mesa Project" or "OSMesa"
  std::string vendor;            ///< GL_VENDOR
  std::string renderer;          ///< GL_RENDERER
  std::string version;           ///< GL_VERSION
  std::string shading_language;  ///< GL_SHADING_LANGUAGE_VERSION
  int max_texture_size = 0;      ///< texels a side
  std::vector<Limit> limits;     ///< others that maps and images run into
};

/// Move-only owner of an OpenGL 4.5 core context. Several may exist, on different back ends too, but GL calls
/// go to the one that is current; all of them belong to one thread.
class Context {
 public:
  /// Takes the device that `choose` (gl/choice.h) prefers among those that give a context, and makes it
  /// current. Fails with Failure::kMachine, saying what is missing and which package brings it.
  [[nodiscard]] static Result<Context> create(const Request& request = {});

  Context(Context&&) noexcept;
  Context& operator=(Context&&) noexcept;
  ~Context();

  /// Sends GL calls here again, after another context was made or made current. Costs nothing where it is
  /// current already; does nothing on a context that was moved from.
  [[nodiscard]] Result<Done> make_current();

  [[nodiscard]] const Info& info() const;

  /// Every device, each tried: what it is, or why it gives no context. Takes a context's time a device.
  [[nodiscard]] static Found survey();

 private:
  struct State;
  explicit Context(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace gnomon::gl
