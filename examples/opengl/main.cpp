// SPDX-License-Identifier: MIT
// The shadow of a height map in plain OpenGL 3.3, without a window and without a GL loader:
//   heights -> R32F texture -> block maxima in the mip levels of a second one -> one draw -> image.
#define GL_GLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/glcorearb.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Made by gnomonc: each shader's text, and the names that it binds.
#include "extrema.frag.h"
#include "fullscreen.vert.h"
#include "shadow.frag.h"

namespace fullscreen = gnomon_shaders::fullscreen_vert::glsl330;
namespace extrema = gnomon_shaders::extrema_frag::glsl330;
namespace shadow = gnomon_shaders::shadow_frag::glsl330;

constexpr int kLevels = 7;  // of block maxima: the coarsest block has 128 x 128 patches

struct Options {
  std::string heights, out;
  std::map<std::string, std::array<double, 2>> pairs = {{"--sun", {315, 45}}, {"--spacing", {1, 1}}};
};

struct Heights {
  int width, height;
  std::vector<float> metres;  // row by row, the northern first, as image files have it
};

void require(bool held, const std::string& otherwise) {
  if (!held) throw std::runtime_error(otherwise);
}

Options parse(const std::vector<std::string>& words) {
  Options options;
  bool understood = words.size() >= 2 && words.size() % 2 == 0;
  for (std::size_t i = 2; understood && i < words.size(); i += 2) {
    const auto option = options.pairs.find(words[i]);
    understood = option != options.pairs.end() &&
                 std::sscanf(words[i + 1].c_str(), "%lf,%lf", &option->second[0], &option->second[1]) == 2;
  }
  require(understood, "usage: terrain_shadow HEIGHTS OUT [--sun AZIMUTH,ELEVATION] [--spacing X,Y]");
  options.heights = words[0], options.out = words[1];
  return options;
}

Heights read_heights(const std::string& path) {
  const auto file = OIIO::ImageInput::open(path);
  require(file != nullptr, path + ": " + OIIO::geterror());
  const OIIO::ImageSpec& spec = file->spec();
  Heights heights{spec.width, spec.height, std::vector<float>(spec.image_pixels())};
  const bool read = file->read_image(0, 0, 0, 1, OIIO::TypeDesc::FLOAT, heights.metres.data());
  require(read, path + ": " + file->geterror());
  // OpenImageIO makes 0..1 of integers; a height is the number that is stored.
  if (spec.format == OIIO::TypeDesc::UINT16)
    for (float& height : heights.metres) height = std::round(height * 65535.0F);
  require(spec.format == OIIO::TypeDesc::UINT16 || spec.format == OIIO::TypeDesc::FLOAT,
          path + ": neither a 16-bit image, such as PNG, nor one of 32-bit floats, such as EXR");
  return heights;
}

void write_image(const std::string& path, const Heights& heights, const std::vector<float>& rgba) {
  const bool data = path.ends_with(".exr");  // else a picture for people
  const auto type = data ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8;
  OIIO::ImageSpec spec(heights.width, heights.height, data ? 1 : 3, type);
  if (data) spec.channelnames = {"b_shadow"};
  const float* first = &rgba[data ? 3 : 0];
  const auto file = OIIO::ImageOutput::create(path);
  require(file != nullptr, path + ": " + OIIO::geterror());
  const bool written = file->open(path, spec) &&
                       file->write_image(OIIO::TypeDesc::FLOAT, first, 4 * sizeof(float)) && file->close();
  require(written, path + ": " + file->geterror());
}

// A context without a surface: everything is drawn into textures.
void make_context() {
  const EGLDisplay display =
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  const bool ready = eglInitialize(display, nullptr, nullptr) && eglBindAPI(EGL_OPENGL_API);
  require(ready, "EGL cannot draw with OpenGL and without a window here");
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 3, EGL_NONE};
  const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  const bool current = context && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
  require(current, "the driver has no OpenGL 3.3 core profile");
  GLuint name = 0;
  glGenVertexArrays(1, &name);  // the core profile draws nothing without one
  glBindVertexArray(name);
  glGenFramebuffers(1, &name);
  glBindFramebuffer(GL_FRAMEBUFFER, name);
}

GLuint make_program(std::string_view fragment_source) {
  const GLuint program = glCreateProgram();
  const GLenum stages[] = {GL_VERTEX_SHADER, GL_FRAGMENT_SHADER};
  const char* sources[] = {fullscreen::source.data(), fragment_source.data()};
  for (int i = 0; i < 2; ++i) {
    const GLuint shader = glCreateShader(stages[i]);
    glShaderSource(shader, 1, &sources[i], nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  char log[4096] = "";
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  require(linked == GL_TRUE, std::string("the driver refuses a shader: ") + log);
  glUseProgram(program);
  return program;
}

// GLSL 3.30 binds by name. The header has a constant for each, so a misspelt one does not compile.
template <class Variable>
GLint location(GLuint program, const Variable& variable) {
  return glGetUniformLocation(program, variable.name.data());
}

GLuint make_texture(GLenum unit, GLint internal_format, GLenum format, int width, int height, int levels,
                    const float* texels) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  for (int k = 0; k < levels; ++k)
    glTexImage2D(GL_TEXTURE_2D, k, internal_format, width >> k, height >> k, 0, format, GL_FLOAT, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, levels - 1);
  return texture;
}

void draw_into(GLuint texture, int width, int height) {
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
  const bool complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  require(complete, "the driver cannot draw into float textures");
  glViewport(0, 0, width, height);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

// Block maxima of the heights in unit 0, left in unit 1. To be made again when heights change.
void build_extrema(const Heights& heights) {
  // A map has (width + 1) x (height + 1) patches. Whole blocks of the coarsest level cover them, so that no
  // halving of a mip level drops one.
  const int width = ((heights.width >> kLevels) + 1) << (kLevels - 1);
  const int height = ((heights.height >> kLevels) + 1) << (kLevels - 1);
  // No draw may see the texture that it writes, so each level is drawn beside it and copied into it.
  const GLuint drawn = make_texture(GL_TEXTURE2, GL_R32F, GL_RED, width, height, 1, nullptr);
  make_texture(GL_TEXTURE1, GL_R32F, GL_RED, width, height, kLevels, nullptr);
  const GLuint program = make_program(extrema::source);
  glUniform1i(location(program, extrema::textures::gnomon_heights), 0);
  glUniform1i(location(program, extrema::textures::gnomon_extrema), 1);
  for (int k = 0; k < kLevels; ++k) {
    glUniform1i(location(program, extrema::uniforms::u_level), k + 1);
    draw_into(drawn, width >> k, height >> k);
    glCopyTexSubImage2D(GL_TEXTURE_2D, k, 0, 0, 0, 0, width >> k, height >> k);
  }
}

std::vector<float> draw_shadow(const Heights& heights, const Options& options) {
  const auto [azimuth, elevation] = options.pairs.at("--sun");
  const auto [spacing_x, spacing_y] = options.pairs.at("--spacing");
  const double around = azimuth * std::numbers::pi / 180, up = elevation * std::numbers::pi / 180;
  const GLuint program = make_program(shadow::source);
  glUniform1i(location(program, shadow::textures::gnomon_heights), 0);
  glUniform1i(location(program, shadow::textures::gnomon_extrema), 1);
  glUniform2i(location(program, shadow::uniforms::u_size), heights.width, heights.height);
  glUniform2f(location(program, shadow::uniforms::u_spacing), float(spacing_x), float(spacing_y));
  glUniform1f(location(program, shadow::uniforms::u_highest), *std::ranges::max_element(heights.metres));
  glUniform1i(location(program, shadow::uniforms::u_top_level), kLevels);
  glUniform3f(location(program, shadow::uniforms::u_to_sun), float(std::sin(around) * std::cos(up)),
              float(std::cos(around) * std::cos(up)), float(std::sin(up)));
  const auto [width, height, metres] = heights;
  draw_into(make_texture(GL_TEXTURE2, GL_RGBA32F, GL_RGBA, width, height, 1, nullptr), width, height);
  std::vector<float> rgba(4 * metres.size());
  glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
  require(glGetError() == GL_NO_ERROR, "OpenGL reports an error");
  for (std::size_t i = 3; i < rgba.size(); i += 4) require(rgba[i] >= 0, "a ray reached its step limit");
  return rgba;
}

int main(int argc, char** argv) try {
  const Options options = parse({argv + 1, argv + argc});
  const Heights heights = read_heights(options.heights);
  make_context();
  make_texture(GL_TEXTURE0, GL_R32F, GL_RED, heights.width, heights.height, 1, heights.metres.data());
  build_extrema(heights);
  write_image(options.out, heights, draw_shadow(heights, options));
} catch (const std::exception& error) {
  std::fprintf(stderr, "terrain_shadow: %s\n", error.what());
  return 1;
}
