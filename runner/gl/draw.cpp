// SPDX-License-Identifier: MIT
#include "gl/draw.h"

#include <glad/gl.h>

namespace gnomon::gl {
namespace {

class Framebuffer {
 public:
  Framebuffer(const Texture& target, int level) {
    glCreateFramebuffers(1, &name_);
    glNamedFramebufferTexture(name_, GL_COLOR_ATTACHMENT0, target.name(), level);
  }
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  ~Framebuffer() { glDeleteFramebuffers(1, &name_); }

  [[nodiscard]] GLuint name() const { return name_; }
  [[nodiscard]] bool complete() const {
    return glCheckNamedFramebufferStatus(name_, GL_DRAW_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }

 private:
  GLuint name_ = 0;
};

struct SetUniform {
  GLuint program;
  GLint location;
  void operator()(int v) const { glProgramUniform1i(program, location, v); }
  void operator()(float v) const { glProgramUniform1f(program, location, v); }
  void operator()(glm::ivec2 v) const { glProgramUniform2i(program, location, v.x, v.y); }
  void operator()(glm::vec2 v) const { glProgramUniform2f(program, location, v.x, v.y); }
  void operator()(glm::vec3 v) const { glProgramUniform3f(program, location, v.x, v.y, v.z); }
};

void bind_inputs(const Pass& pass) {
  const GLuint program = pass.program->name();
  for (const auto& [name, value] : pass.uniforms) {
    std::visit(SetUniform{program, glGetUniformLocation(program, name.c_str())}, value);
  }
  GLint unit = 0;
  for (const Sampler& sampler : pass.samplers) {
    const GLuint texture = sampler.texture->name();
    glTextureParameteri(texture, GL_TEXTURE_BASE_LEVEL, sampler.first_level);
    glTextureParameteri(texture, GL_TEXTURE_MAX_LEVEL, sampler.last_level);
    glBindTextureUnit(static_cast<GLuint>(unit), texture);
    glProgramUniform1i(program, glGetUniformLocation(program, sampler.name.c_str()), unit++);
  }
  GLuint binding = 0;
  for (const auto& [name, buffer] : pass.buffers) {
    const GLuint block = glGetProgramResourceIndex(program, GL_SHADER_STORAGE_BLOCK, name.c_str());
    if (block != GL_INVALID_INDEX) {
      glShaderStorageBlockBinding(program, block, binding);
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding++, buffer->name());
    } else {
      glBindTextureUnit(static_cast<GLuint>(unit), buffer->view());
      glProgramUniform1i(program, glGetUniformLocation(program, name.c_str()), unit++);
    }
  }
}

}  // namespace

Result<Done> draw(const Pass& pass) {
  const Framebuffer framebuffer(*pass.target, pass.target_level);
  if (!framebuffer.complete()) {
    return Diagnostic{.message = "the OpenGL driver cannot render to a float texture",
                      .failure = Failure::kMachine};
  }
  const Size size = pass.target->size(pass.target_level);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name());
  glViewport(0, 0, size.width, size.height);
  glUseProgram(pass.program->name());
  bind_inputs(pass);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glFinish();
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return Done{};
  return Diagnostic{.message = "OpenGL error " + std::to_string(error) + " while drawing (" +
                               (error == GL_OUT_OF_MEMORY ? "out of memory" : "a driver fault") + ")",
                    .failure = Failure::kMachine};
}

}  // namespace gnomon::gl
