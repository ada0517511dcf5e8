// SPDX-License-Identifier: MIT
// Floats in linear memory.
#pragma once

#include <span>

#include "gnomon/diagnostic.h"

namespace gnomon::gl {

/// Move-only owner of an immutable buffer of floats, which shaders read as a storage block or, through its
/// view, as a samplerBuffer.
class Buffer {
 public:
  /// Fails with kInvalid where there are more values than the driver's texture buffers hold (the message
  /// names the limit) and with kMachine where memory runs out. Needs at least one value.
  [[nodiscard]] static Result<Buffer> create(std::span<const float> values);

  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;
  ~Buffer();

  [[nodiscard]] unsigned name() const { return name_; }
  /// The R32F texture buffer over all values.
  [[nodiscard]] unsigned view() const { return view_; }

 private:
  Buffer(unsigned name, unsigned view) : name_(name), view_(view) {}
  unsigned name_ = 0;
  unsigned view_ = 0;
};

}  // namespace gnomon::gl
