// SPDX-License-Identifier: MIT
// Two-dimensional textures: of floats, and of the encodings that heights are stored in.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::gl {

enum class Format {
  kR32F,
  kRg32F,
  kRgba32F,
  kR16,      ///< 0..65535, read as 0..1
  kR16Ui,    ///< 0..65535, read as integers
  kRgba8,    ///< 0..255, read as 0..1; linear, not sRGB
  kDepth32F  ///< what meshes are drawn with; read as floats
};

struct Size {
  int width = 0;
  int height = 0;
};

/// Move-only owner of an immutable, nearest-filtered texture that is clamped to its edge.
class Texture {
 public:
  /// `levels` mip levels of which each halves the one above, rounded down. Fails with kInvalid where a side
  /// exceeds the driver's limit (the message names it) and with kMachine where memory runs out.
  [[nodiscard]] static Result<Texture> create(Format format, Size size, int levels = 1);

  Texture(Texture&& other) noexcept;
  Texture& operator=(Texture&& other) noexcept;
  ~Texture();

  [[nodiscard]] unsigned name() const { return name_; }
  [[nodiscard]] int levels() const { return levels_; }
  [[nodiscard]] Size size(int level = 0) const { return {size_.width >> level, size_.height >> level}; }

  /// Fills level 0; row-major, first row at texel row 0. Needs width * height * components values, of the
  /// type that the format stores: float, 16 or 8 bits.
  void upload(std::span<const float> values) { fill(values.data()); }
  void upload(std::span<const std::uint16_t> values) { fill(values.data()); }
  void upload(std::span<const std::uint8_t> values) { fill(values.data()); }
  /// All values of a level as floats, row-major; not of kR16Ui.
  [[nodiscard]] std::vector<float> download(int level = 0) const;

 private:
  Texture(unsigned name, Format format, Size size, int levels)
      : name_(name), format_(format), size_(size), levels_(levels) {}
  void fill(const void* values);

  unsigned name_ = 0;
  Format format_ = Format::kR32F;
  Size size_;
  int levels_ = 1;
};

}  // namespace gnomon::gl
