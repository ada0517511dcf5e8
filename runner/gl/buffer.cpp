// SPDX-License-Identifier: MIT
#include "gl/buffer.h"

#include <glad/gl.h>

#include <string>
#include <utility>

#include "gl/errors.h"

namespace gnomon::gl {

Result<Buffer> Buffer::create(std::span<const float> values) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  if (values.size() > static_cast<std::size_t>(limit)) {
    return Diagnostic{.message = std::to_string(values.size()) +
                                 " values are more than this OpenGL driver's texture buffers hold, " +
                                 std::to_string(limit) + ". Use a smaller height map, or cut it into tiles"};
  }
  clear_errors();
  GLuint name = 0;
  GLuint view = 0;
  glCreateBuffers(1, &name);
  glCreateTextures(GL_TEXTURE_BUFFER, 1, &view);
  Buffer buffer(name, view);
  glNamedBufferStorage(name, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), 0);
  glTextureBuffer(view, GL_R32F, name);
  if (glGetError() != GL_NO_ERROR) {
    return Diagnostic{.message = "the OpenGL driver has no memory for a buffer of " +
                                 std::to_string(values.size()) + " values",
                      .failure = Failure::kMachine};
  }
  return buffer;
}

Buffer::Buffer(Buffer&& other) noexcept
    : name_(std::exchange(other.name_, 0)), view_(std::exchange(other.view_, 0)) {}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(name_, other.name_);
  std::swap(view_, other.view_);
  return *this;
}

Buffer::~Buffer() {
  if (view_ != 0) glDeleteTextures(1, &view_);
  if (name_ != 0) glDeleteBuffers(1, &name_);
}

}  // namespace gnomon::gl
