// SPDX-License-Identifier: MIT
#include "gl/texture.h"

#include <glad/gl.h>

#include <algorithm>
#include <string>
#include <utility>

#include "gl/errors.h"

namespace gnomon::gl {
namespace {

struct GlFormat {
  GLenum internal_format;
  GLenum format;
  GLenum type;  // of a component
  int components;
};

GlFormat gl_format(Format format) {
  switch (format) {
    case Format::kR32F:
      break;
    case Format::kRg32F:
      return {GL_RG32F, GL_RG, GL_FLOAT, 2};
    case Format::kRgba32F:
      return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 4};
    case Format::kR16:
      return {GL_R16, GL_RED, GL_UNSIGNED_SHORT, 1};
    case Format::kR16Ui:
      return {GL_R16UI, GL_RED_INTEGER, GL_UNSIGNED_SHORT, 1};
    case Format::kRgba8:
      return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
    case Format::kDepth32F:
      return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 1};
  }
  return {GL_R32F, GL_RED, GL_FLOAT, 1};
}

}  // namespace

Result<Texture> Texture::create(Format format, Size size, int levels) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
  const std::string asked = std::to_string(size.width) + " x " + std::to_string(size.height);
  if (std::max(size.width, size.height) > limit) {
    return Diagnostic{.message = asked + " texels are more than this OpenGL driver's limit of " +
                                 std::to_string(limit) +
                                 " a side. Use a smaller height map, or cut it into tiles"};
  }
  clear_errors();
  GLuint name = 0;
  glCreateTextures(GL_TEXTURE_2D, 1, &name);
  Texture texture(name, format, size, levels);
  glTextureStorage2D(name, levels, gl_format(format).internal_format, size.width, size.height);
  if (glGetError() != GL_NO_ERROR) {
    return Diagnostic{.message = "the OpenGL driver has no memory for a texture of " + asked + " texels",
                      .failure = Failure::kMachine};
  }
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, levels > 1 ? GL_NEAREST_MIPMAP_NEAREST : GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

Texture::Texture(Texture&& other) noexcept
    : name_(std::exchange(other.name_, 0)),
      format_(other.format_),
      size_(other.size_),
      levels_(other.levels_) {}

Texture& Texture::operator=(Texture&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(format_, other.format_);
  std::swap(size_, other.size_);
  std::swap(levels_, other.levels_);
  return *this;
}

Texture::~Texture() {
  if (name_ != 0) glDeleteTextures(1, &name_);
}

void Texture::fill(const void* values) {
  const GlFormat format = gl_format(format_);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(name_, 0, 0, 0, size_.width, size_.height, format.format, format.type, values);
}

std::vector<float> Texture::download(int level) const {
  const Size at = size(level);
  const auto count = static_cast<std::size_t>(at.width) * static_cast<std::size_t>(at.height) *
                     static_cast<std::size_t>(gl_format(format_).components);
  std::vector<float> values(count);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  // The size counts bytes in a GLsizei: row bands keep it below 2^31 for the largest textures.
  const std::size_t row = count / static_cast<std::size_t>(at.height);
  const int band = std::max(1, static_cast<int>((std::size_t{1} << 28) / row));
  for (int y = 0; y < at.height; y += band) {
    const int rows = std::min(band, at.height - y);
    glGetTextureSubImage(name_, level, 0, y, 0, at.width, rows, 1, gl_format(format_).format, GL_FLOAT,
                         static_cast<GLsizei>(static_cast<std::size_t>(rows) * row * sizeof(float)),
                         values.data() + static_cast<std::size_t>(y) * row);
  }
  return values;
}

}  // namespace gnomon::gl
