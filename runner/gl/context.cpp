// SPDX-License-Identifier: MIT
#include "gl/context.h"

#include <dlfcn.h>
#include <glad/gl.h>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <type_traits>
#include <utility>

namespace gnomon::gl {
namespace {

Diagnostic no_context(const std::string& what) {
  return {.message = "no OpenGL context: " + what +
                     ". Rendering needs EGL and a driver (Debian: libegl1, libegl-mesa0, libgl1-mesa-dri); "
                     "'--method reference' needs neither",
          .failure = Failure::kMachine};
}

/// libEGL is opened at run time, so that everything that needs no GL works on a machine without it.
class EglLibrary {
 public:
  EglLibrary() : handle_(dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL)) {}
  // Never closed: drivers register exit handlers, and unloading them crashes some.
  [[nodiscard]] bool loaded() const { return handle_ != nullptr; }

  template <class Function>
  [[nodiscard]] Function* get(const char* name) const {
    return reinterpret_cast<Function*>(dlsym(handle_, name));
  }

 private:
  void* handle_;
};

std::string text_of(const GLubyte* text) {
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

struct Context::State {
  EglLibrary egl;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  GLuint vertex_array = 0;
  Info info;

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  ~State() {
    if (display == EGL_NO_DISPLAY) return;
    if (context != EGL_NO_CONTEXT) {
      if (vertex_array != 0) glDeleteVertexArrays(1, &vertex_array);
      egl.get<decltype(eglMakeCurrent)>("eglMakeCurrent")(display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                                          EGL_NO_CONTEXT);
      egl.get<decltype(eglDestroyContext)>("eglDestroyContext")(display, context);
    }
    egl.get<decltype(eglTerminate)>("eglTerminate")(display);
  }

  /// Empty on success, else what failed.
  std::string open_display() {
    if (!egl.loaded()) return "libEGL.so.1 cannot be loaded";
    const auto get_platform_display = egl.get<decltype(eglGetPlatformDisplay)>("eglGetPlatformDisplay");
    if (!get_platform_display) return "libEGL.so.1 is older than EGL 1.5";
    const EGLDisplay opened =
        get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (opened == EGL_NO_DISPLAY) return "EGL offers no surfaceless platform";
    if (!egl.get<decltype(eglInitialize)>("eglInitialize")(opened, nullptr, nullptr))
      return "eglInitialize failed";
    display = opened;
    const auto query = egl.get<decltype(eglQueryString)>("eglQueryString");
    info.egl = std::string(query(display, EGL_VERSION)) + ", " + query(display, EGL_VENDOR);
    info.backend = "egl (surfaceless)";
    return {};
  }

  std::string make_context() {
    if (!egl.get<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API)) return "EGL has no desktop OpenGL";
    const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                 4,
                                 EGL_CONTEXT_MINOR_VERSION,
                                 5,
                                 EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                 EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                 EGL_NONE};
    context = egl.get<decltype(eglCreateContext)>("eglCreateContext")(display, EGL_NO_CONFIG_KHR,
                                                                      EGL_NO_CONTEXT, attributes);
    if (context == EGL_NO_CONTEXT) return "the driver has no OpenGL 4.5 core profile";
    const auto make_current = egl.get<decltype(eglMakeCurrent)>("eglMakeCurrent");
    if (!make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) return "eglMakeCurrent failed";
    const auto get_address = egl.get<decltype(eglGetProcAddress)>("eglGetProcAddress");
    if (!gladLoadGL(reinterpret_cast<GLADloadfunc>(get_address))) return "the GL functions cannot be loaded";
    return {};
  }

  void read_info() {
    info.vendor = text_of(glGetString(GL_VENDOR));
    info.renderer = text_of(glGetString(GL_RENDERER));
    info.version = text_of(glGetString(GL_VERSION));
    info.shading_language = text_of(glGetString(GL_SHADING_LANGUAGE_VERSION));
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &info.max_texture_size);
  }
};

Result<Context> Context::create() {
  auto state = std::make_unique<State>();
  if (const std::string failure = state->open_display(); !failure.empty()) return no_context(failure);
  if (const std::string failure = state->make_context(); !failure.empty()) return no_context(failure);
  state->read_info();
  // The core profile draws nothing without a vertex array, and ours needs no attributes: one, bound for good.
  glCreateVertexArrays(1, &state->vertex_array);
  glBindVertexArray(state->vertex_array);
  return Context(std::move(state));
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

const Info& Context::info() const {
  return state_->info;
}

}  // namespace gnomon::gl
