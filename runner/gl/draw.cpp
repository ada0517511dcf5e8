// SPDX-License-Identifier: MIT
#include "gl/draw.h"

#include <glad/gl.h>

#include <algorithm>

namespace gnomon::gl {
namespace {

class Framebuffer {
 public:
  explicit Framebuffer(const Pass& pass) {
    glCreateFramebuffers(1, &name_);
    if (pass.target)
      glNamedFramebufferTexture(name_, GL_COLOR_ATTACHMENT0, pass.target->name(), pass.target_level);
    if (!pass.target) glNamedFramebufferDrawBuffer(name_, GL_NONE);
    if (pass.mesh) glNamedFramebufferTexture(name_, GL_DEPTH_ATTACHMENT, pass.mesh->depth->name(), 0);
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

Window window_of(const Pass& pass) {
  if (pass.window) return *pass.window;
  const Size size = pass.target ? pass.target->size(pass.target_level) : pass.mesh->depth->size();
  return {.size = {size.width, size.height}};
}

/// Depth and culling are on only while it lives.
class DepthState {
 public:
  explicit DepthState(Faces faces) {
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glFrontFace(GL_CW);
    glCullFace(faces == Faces::kBack ? GL_FRONT : GL_BACK);
    if (faces != Faces::kAll) glEnable(GL_CULL_FACE);
  }
  DepthState(const DepthState&) = delete;
  DepthState& operator=(const DepthState&) = delete;
  ~DepthState() {
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
  }
};

void clear(const Framebuffer& framebuffer, const Pass& pass, const Window& window) {
  constexpr GLfloat kFarthest = 0;
  glScissor(window.first.x, window.first.y, window.size.x, window.size.y);
  glEnable(GL_SCISSOR_TEST);
  glClearNamedFramebufferfv(framebuffer.name(), GL_DEPTH, 0, &kFarthest);
  if (pass.target) glClearNamedFramebufferfv(framebuffer.name(), GL_COLOR, 0, &pass.mesh->background.x);
  glDisable(GL_SCISSOR_TEST);
}

/// A hardware driver resets a context whose single draw takes seconds: not many more vertices or pixels go to
/// it at once.
constexpr int kMostVertices = 1 << 24;
constexpr int kMostPixels = 1 << 20;

/// Draws a part, whose strips may be several draws; adds its vertices to `waiting`, those not yet on their
/// way.
void draw_part(const Mesh::Part& part, GLuint program, GLint first_node, int& waiting) {
  const int strip_vertices = 2 * (part.cells.x + 1);
  const int most = std::max(kMostVertices / strip_vertices, 1);
  for (int strip = 0; strip < part.cells.y; strip += most) {
    const int strips = std::min(most, part.cells.y - strip);
    glProgramUniform2i(program, first_node, part.first.x, part.first.y + strip);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, strip_vertices, strips);
    waiting += strips * strip_vertices;
    if (waiting < kMostVertices / 2) continue;
    glFlush();
    waiting = 0;
  }
}

void draw_mesh(const Mesh& mesh, GLuint program) {
  const DepthState state(mesh.faces);
  const GLint first_node = glGetUniformLocation(program, "u_first_node");
  int waiting = 0;
  for (const Mesh::Part& part : mesh.parts) draw_part(part, program, first_node, waiting);
  glFlush();
}

void draw_pass(const Framebuffer& framebuffer, const Pass& pass) {
  glUseProgram(pass.program->name());
  bind_inputs(pass);
  const Window window = window_of(pass);
  glViewport(window.first.x, window.first.y, window.size.x, window.size.y);
  if (!pass.mesh) return glDrawArrays(GL_TRIANGLES, 0, 3);
  clear(framebuffer, pass, window);
  draw_mesh(*pass.mesh, pass.program->name());
}

}  // namespace

Result<Done> draw(std::span<const Pass> passes) {
  if (passes.empty()) return Done{};
  const Framebuffer framebuffer(passes.front());
  if (!framebuffer.complete()) {
    return Diagnostic{.message = "the OpenGL driver cannot render to a float or depth texture",
                      .failure = Failure::kMachine};
  }
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.name());
  int waiting = 0;  // pixels
  for (const Pass& pass : passes) {
    const glm::ivec2 size = window_of(pass).size;
    waiting += size.x * size.y;
    if (waiting > kMostPixels) {
      glFlush();
      waiting = size.x * size.y;
    }
    draw_pass(framebuffer, pass);
  }
  glFinish();
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return Done{};
  return Diagnostic{.message = "OpenGL error " + std::to_string(error) + " while drawing (" +
                               (error == GL_OUT_OF_MEMORY ? "out of memory" : "a driver fault") + ")",
                    .failure = Failure::kMachine};
}

}  // namespace gnomon::gl
