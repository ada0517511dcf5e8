// SPDX-License-Identifier: MIT
#include "gl/program.h"

#include <glad/gl.h>

#include <algorithm>
#include <utility>

namespace gnomon::gl {
namespace {

std::string first_line(const std::string& log) {
  return log.substr(0, log.find('\n'));
}

/// Empty on success, else the driver's log.
std::string attach(GLuint program, GLenum stage, const std::string& source) {
  const GLuint shader = glCreateShader(stage);
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  std::string log(1024, '\0');
  GLsizei length = 0;
  glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  if (compiled) glAttachShader(program, shader);
  glDeleteShader(shader);  // kept by the program for as long as it is attached
  return compiled ? std::string() : (log.empty() ? "no reason given" : first_line(log));
}

std::string link_program(GLuint program) {
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked) return {};
  std::string log(1024, '\0');
  GLsizei length = 0;
  glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), &length, log.data());
  log.resize(static_cast<std::size_t>(length));
  return log.empty() ? "no reason given" : first_line(log);
}

bool is_sampler(GLint type) {
  return type == GL_SAMPLER_2D || type == GL_INT_SAMPLER_2D || type == GL_UNSIGNED_INT_SAMPLER_2D ||
         type == GL_SAMPLER_BUFFER;
}

/// Two samplers of different types on one unit make every draw fail, also where a draw uses only one of them
/// and leaves the other at its initial unit 0: each begins on a unit of its own, above those that draws bind.
void spread_samplers(GLuint program) {
  constexpr GLint kFirstSpareUnit = 32;
  GLint count = 0;
  glGetProgramInterfaceiv(program, GL_UNIFORM, GL_ACTIVE_RESOURCES, &count);
  for (GLint i = 0; i < count; ++i) {
    constexpr GLenum kWanted[] = {GL_TYPE, GL_LOCATION};
    GLint found[2] = {};
    glGetProgramResourceiv(program, GL_UNIFORM, static_cast<GLuint>(i), 2, kWanted, 2, nullptr, found);
    if (is_sampler(found[0])) glProgramUniform1i(program, found[1], kFirstSpareUnit + i);
  }
}

}  // namespace

Result<Program> Program::link(const std::string& name, const std::string& vertex_source,
                              const std::string& fragment_source) {
  Program program(glCreateProgram());
  std::string failure = attach(program.name(), GL_VERTEX_SHADER, vertex_source);
  if (failure.empty()) failure = attach(program.name(), GL_FRAGMENT_SHADER, fragment_source);
  if (failure.empty()) failure = link_program(program.name());
  if (failure.empty()) {
    spread_samplers(program.name());
    return program;
  }
  return Diagnostic{.file = name,
                    .message = "the OpenGL driver refuses this program: " + failure,
                    .failure = Failure::kFailed};
}

Program::Program(Program&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
Program& Program::operator=(Program&& other) noexcept {
  std::swap(name_, other.name_);
  return *this;
}
Program::~Program() {
  if (name_ != 0) glDeleteProgram(name_);
}

}  // namespace gnomon::gl
