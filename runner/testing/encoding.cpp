// SPDX-License-Identifier: MIT
#include "testing/encoding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace gnomon::testing {
namespace {

using Layout = Encoding::Layout;

const std::vector<std::string> kEveryDialect{"glsl450", "glsl330", "essl300", "essl310"};
constexpr int kLargest16 = 0xFFFF;
constexpr int kLargestRgb = 0xFFFFFF;
/// Texels a row of a texture that is linear memory: no divisor of any map's width.
constexpr int kLinearWidth = 103;

float as_stored(int stored) {
  return static_cast<float>(stored);
}
float eighths(int stored) {
  return static_cast<float>(stored * 0.125 - 431.25);
}
float sixteenths(int stored) {
  return static_cast<float>(stored * 0.0625 - 500);
}
// Product and sum round here.
float tenths(int stored) {
  const float product = static_cast<float>(stored) * 0.1F;
  return product + -333.3F;
}
float mapbox(int stored) {
  return static_cast<float>(stored - 100000) / 10.0F;
}
float terrarium(int stored) {
  return static_cast<float>(stored / 256.0 - 32768);
}

std::vector<std::uint8_t> rgba(const std::vector<int>& numbers) {
  std::vector<std::uint8_t> bytes;
  bytes.reserve(4 * numbers.size());
  for (const int n : numbers) {
    for (const int byte : {n >> 16, n >> 8 & 0xFF, n & 0xFF, 0xFF})
      bytes.push_back(static_cast<std::uint8_t>(byte));
  }
  return bytes;
}

}  // namespace

const std::vector<Encoding>& encodings() {
  using enum gl::Format;
  static const std::vector<Encoding> table = {
      {.name = "r32f", .host = "r32f", .targets = kEveryDialect},
      {.name = "r16",
       .host = "r16",
       .targets = kEveryDialect,
       .format = kR16,
       .largest = kLargest16,
       .decode = as_stored},
      {.name = "r16_scaled",
       .host = "r16",
       .prelude = "#define GNOMON_R16_SCALE 0.125\n#define GNOMON_R16_OFFSET -431.25\n",
       .targets = kEveryDialect,
       .format = kR16,
       .largest = kLargest16,
       .decode = eighths},
      {.name = "r16_integer",
       .host = "r16",
       .prelude = "#define GNOMON_R16_INTEGER\nuniform float u_scale, u_offset;\n"
                  "#define GNOMON_R16_SCALE u_scale\n#define GNOMON_R16_OFFSET u_offset\n",
       .targets = kEveryDialect,
       .format = kR16Ui,
       .largest = kLargest16,
       .decode = sixteenths,
       .uniforms = {{"u_scale", 0.0625F}, {"u_offset", -500.0F}}},
      {.name = "r16_rounded",
       .host = "r16",
       .prelude = "#define GNOMON_R16_SCALE 0.1\n#define GNOMON_R16_OFFSET -333.3\n",
       .targets = {"glsl450"},  // the others have no `precise`
       .format = kR16,
       .largest = kLargest16,
       .decode = tenths},
      {.name = "terrain_rgb",
       .host = "terrain_rgb",
       .targets = kEveryDialect,
       .format = kRgba8,
       .largest = kLargestRgb,
       .decode = mapbox},
      {.name = "terrarium",
       .host = "terrain_rgb",
       .prelude = "#define GNOMON_TERRARIUM\n",
       .targets = kEveryDialect,
       .format = kRgba8,
       .largest = kLargestRgb,
       .decode = terrarium},
      {.name = "buffer",
       .host = "buffer",
       .targets = {"glsl450", "glsl330", "essl310"},
       .layout = Layout::kBuffer},
      {.name = "buffer_without_buffers",
       .host = "buffer",
       .targets = {"essl300"},
       .layout = Layout::kLinearTexture},
      {.name = "buffer_texture",
       .host = "buffer",
       .prelude = "#define GNOMON_BUFFER_KIND GNOMON_BUFFER_TEXTURE\n",
       .targets = {"glsl450", "glsl330"},
       .layout = Layout::kBuffer},
      {.name = "buffer_linear",
       .host = "buffer",
       .prelude = "#define GNOMON_BUFFER_KIND GNOMON_BUFFER_LINEAR\n",
       .targets = kEveryDialect,
       .layout = Layout::kLinearTexture},
  };
  return table;
}

Stored Encoding::store(const terrain::HeightMap& map) const {
  Stored stored{.numbers = {}, .decoded = map};
  if (decode == nullptr) return stored;
  const double lowest = decode(0);
  const double step = (decode(largest) - lowest) / largest;
  for (float& sample : stored.decoded.samples) {
    stored.numbers.push_back(
        static_cast<int>(std::clamp<double>(std::round((sample - lowest) / step), 0.0, largest)));
    sample = decode(stored.numbers.back());
  }
  return stored;
}

Stored Encoding::store_everything() const {
  const int side = static_cast<int>(std::sqrt(largest + 1.0));
  Stored stored{.numbers = {},
                .decoded = {.width = side,
                            .height = side,
                            .domain_width = double(side),
                            .domain_height = double(side),
                            .samples = {}}};
  for (int i = 0; i <= largest; ++i) {
    stored.numbers.push_back(i);
    stored.decoded.samples.push_back(decode(i));
  }
  return stored;
}

void HostInputs::add(gl::Format format, gl::Size size, const auto& values) {
  Result<gl::Texture> texture = gl::Texture::create(format, size);
  ASSERT_TRUE(texture.ok()) << to_string(texture.diagnostics().front());
  texture->upload(values);
  textures_.push_back(std::move(texture).value());
}

void HostInputs::add_memory(Layout layout, const std::vector<float>& values) {
  if (layout == Layout::kBuffer) {
    Result<gl::Buffer> buffer = gl::Buffer::create(values);
    ASSERT_TRUE(buffer.ok()) << to_string(buffer.diagnostics().front());
    buffers_.push_back(std::move(buffer).value());
    return;
  }
  std::vector<float> rows = values;
  const int count = (static_cast<int>(rows.size()) + kLinearWidth - 1) / kLinearWidth;
  rows.resize(std::size_t(count) * kLinearWidth);
  add(gl::Format::kR32F, {kLinearWidth, count}, rows);
}

HostInputs::HostInputs(const Encoding& encoding, const Stored& stored, const gl::Texture& extrema)
    : extrema_(extrema), uniforms_(encoding.uniforms) {
  const terrain::HeightMap& map = stored.decoded;
  if (encoding.layout != Layout::kTexture) {
    std::vector<float> all_levels;
    for (int level = 0; level < extrema.levels(); ++level) {
      const std::vector<float> blocks = extrema.download(level);
      all_levels.insert(all_levels.end(), blocks.begin(), blocks.end());
    }
    add_memory(encoding.layout, map.samples);
    add_memory(encoding.layout, all_levels);
    uniforms_.emplace_back("gnomon_heights_size", glm::ivec2(map.width, map.height));
    uniforms_.emplace_back("gnomon_extrema_size", glm::ivec2(extrema.size().width, extrema.size().height));
    return;
  }
  const gl::Size size{map.width, map.height};
  if (encoding.decode == nullptr) {
    add(encoding.format, size, map.samples);
  } else if (encoding.format == gl::Format::kRgba8) {
    add(encoding.format, size, rgba(stored.numbers));
  } else {
    add(encoding.format, size, std::vector<std::uint16_t>(stored.numbers.begin(), stored.numbers.end()));
  }
}

std::vector<gl::Sampler> HostInputs::samplers() const {
  if (textures_.empty()) return {};
  if (textures_.size() == 2)
    return {{.name = "gnomon_heights", .texture = &textures_.front()},
            {.name = "gnomon_extrema", .texture = &textures_.back()}};
  return {{.name = "gnomon_heights", .texture = &heights()},
          {.name = "gnomon_extrema", .texture = &extrema_, .last_level = extrema_.levels() - 1}};
}

std::vector<gl::BufferInput> HostInputs::buffers() const {
  if (buffers_.empty()) return {};
  return {{"gnomon_heights", &buffers_.front()}, {"gnomon_extrema", &buffers_.back()}};
}

}  // namespace gnomon::testing
