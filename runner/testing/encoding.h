// SPDX-License-Identifier: MIT
// Height maps in every encoding that shaderlib/host/ reads, and what they mean by a decoder of our own.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gl/draw.h"
#include "technique/pyramid.h"
#include "terrain/height_map.h"

namespace gnomon::testing {

/// A map as it is stored, and the map that this is.
struct Stored {
  std::vector<int> numbers;  ///< row-major, row 0 = north; empty where heights are stored as floats
  terrain::HeightMap decoded;
};

/// A ready-made host with its options.
struct Encoding {
  enum class Layout { kTexture, kBuffer, kLinearTexture };

  std::string name;
  std::string host;                                             ///< shaderlib/host/<host>.glsl
  std::string prelude{};                                        ///< GLSL before it
  std::vector<std::string> targets;                             ///< dialects that it is meant for
  Layout layout = Layout::kTexture;                             ///< what holds the heights
  gl::Format format = gl::Format::kR32F;                        ///< of a texture of heights
  int largest = 0;                                              ///< largest stored number; 0: floats
  float (*decode)(int stored) = nullptr;                        ///< metres
  std::vector<std::pair<std::string, gl::Uniform>> uniforms{};  ///< what the prelude declares

  /// Each height of `map` as the nearest number that can be stored.
  [[nodiscard]] Stored store(const terrain::HeightMap& map) const;
  /// A square map of all numbers that can be stored.
  [[nodiscard]] Stored store_everything() const;
};
[[nodiscard]] const std::vector<Encoding>& encodings();

/// What a shader with an encoding's host functions reads. Needs a current GL context; a failure to make it is
/// a failure of the running test.
class HostInputs {
 public:
  /// `extrema` is in the layout of technique::Pyramid.
  HostInputs(const Encoding& encoding, const Stored& stored, const gl::Texture& extrema);

  [[nodiscard]] const gl::Texture& heights() const { return textures_.front(); }
  [[nodiscard]] std::vector<gl::Sampler> samplers() const;
  [[nodiscard]] std::vector<gl::BufferInput> buffers() const;
  [[nodiscard]] const std::vector<std::pair<std::string, gl::Uniform>>& uniforms() const { return uniforms_; }

 private:
  void add(gl::Format format, gl::Size size, const auto& values);
  void add_memory(Encoding::Layout layout, const std::vector<float>& values);

  const gl::Texture& extrema_;
  std::vector<gl::Texture> textures_;  ///< heights, and extrema where they are linear memory
  std::vector<gl::Buffer> buffers_;    ///< heights, extrema
  std::vector<std::pair<std::string, gl::Uniform>> uniforms_;
};

}  // namespace gnomon::testing
