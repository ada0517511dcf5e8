// SPDX-License-Identifier: MIT
#include "gl/egl.h"

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "gl/library.h"

namespace gnomon::gl {
namespace {

constexpr const char* kPackages =
    "; the Debian packages libegl1, libegl-mesa0 and libgl1-mesa-dri bring it, for an NVIDIA card libegl1 "
    "and "
    "libegl-nvidia0";

const Library& library() {
  static const Library opened{"libEGL.so.1"};
  return opened;
}

/// A function of EGL's core.
template <class Function>
Function* core(const char* name) {
  return library().get<Function>(name);
}

/// A function of an extension; null where there is none.
template <class Function>
Function extension(const char* name) {
  return reinterpret_cast<Function>(core<decltype(eglGetProcAddress)>("eglGetProcAddress")(name));
}

/// Whether a list of extensions, separated by blanks, has one.
bool has(const char* list, const std::string& name) {
  std::istringstream words(list ? list : "");
  for (std::string word; words >> word;) {
    if (word == name) return true;
  }
  return false;
}

const char* client_extensions() {
  return core<decltype(eglQueryString)>("eglQueryString")(EGL_NO_DISPLAY, EGL_EXTENSIONS);
}

std::string failed(const std::string& what) {
  std::ostringstream text;
  text << what << " failed (EGL error 0x" << std::hex << core<decltype(eglGetError)>("eglGetError")() << ")";
  return text.str();
}

// --- devices ------------------------------------------------------------------------------------

std::vector<EGLDeviceEXT> egl_devices() {
  const char* client = client_extensions();
  const bool known = has(client, "EGL_EXT_device_base") || has(client, "EGL_EXT_device_enumeration");
  const auto query = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  if (!known || !has(client, "EGL_EXT_platform_device") || !query) return {};
  EGLint count = 0;
  if (!query(0, nullptr, &count) || count < 1) return {};
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!query(count, devices.data(), &count)) return {};
  devices.resize(static_cast<std::size_t>(count));
  return devices;
}

/// What a device says without a display.
Device described(EGLDeviceEXT handle, int index) {
  Device device{.api = Api::kEgl, .egl_device = index, .place = "EGL device"};
  const auto query = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (!query) return device;
  const char* extensions = query(handle, EGL_EXTENSIONS);
  if (has(extensions, "EGL_MESA_device_software")) device.software = true;
  const auto text = [&](const char* needed, EGLint name) -> std::string {
    const char* value = has(extensions, needed) ? query(handle, name) : nullptr;
    return value ? value : "";
  };
  device.renderer = text("EGL_EXT_device_query_name", EGL_RENDERER_EXT);
  std::string file = text("EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT);
  if (file.empty()) file = text("EGL_EXT_device_drm_render_node", EGL_DRM_RENDER_NODE_FILE_EXT);
  if (!file.empty()) device.place += " " + file;
  return device;
}

// --- displays -----------------------------------------------------------------------------------

/// An initialised display. EGL gives every caller the same one, and terminating it would take the contexts of
/// all: the last user does.
class Display {
 public:
  static std::optional<Display> initialise(EGLDisplay display) {
    if (!core<decltype(eglInitialize)>("eglInitialize")(display, nullptr, nullptr)) return std::nullopt;
    ++uses()[display];
    return Display(display);
  }
  Display(Display&& other) noexcept : display_(std::exchange(other.display_, EGL_NO_DISPLAY)) {}
  Display& operator=(Display&& other) noexcept {
    std::swap(display_, other.display_);
    return *this;
  }
  ~Display() {
    if (display_ == EGL_NO_DISPLAY || --uses()[display_] > 0) return;
    core<decltype(eglTerminate)>("eglTerminate")(display_);
  }

  [[nodiscard]] EGLDisplay get() const { return display_; }
  [[nodiscard]] const char* text(EGLint name) const {
    const char* value = core<decltype(eglQueryString)>("eglQueryString")(display_, name);
    return value ? value : "";
  }

 private:
  explicit Display(EGLDisplay display) : display_(display) {}
  static std::map<EGLDisplay, int>& uses() {
    static std::map<EGLDisplay, int> counts;
    return counts;
  }
  EGLDisplay display_;
};

EGLDisplay display_of(EGLenum platform, void* native) {
  if (const auto get = core<decltype(eglGetPlatformDisplay)>("eglGetPlatformDisplay"))
    return get(platform, native, nullptr);
  const auto get = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return get ? get(platform, native, nullptr) : EGL_NO_DISPLAY;
}

EGLDisplay display_of(int egl_device) {
  if (egl_device == Device::kSurfaceless)
    return display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  const std::vector<EGLDeviceEXT> devices = egl_devices();
  const auto index = static_cast<std::size_t>(egl_device);
  return index < devices.size() ? display_of(EGL_PLATFORM_DEVICE_EXT, devices[index]) : EGL_NO_DISPLAY;
}

// --- contexts -----------------------------------------------------------------------------------

class EglContext final : public Native {
 public:
  explicit EglContext(Display display) : display_(std::move(display)) {}
  ~EglContext() override {
    if (surface_ != EGL_NO_SURFACE)
      core<decltype(eglDestroySurface)>("eglDestroySurface")(display_.get(), surface_);
    if (context_ != EGL_NO_CONTEXT)
      core<decltype(eglDestroyContext)>("eglDestroyContext")(display_.get(), context_);
  }

  /// Empty on success, else what failed.
  std::string make(EglMeans allowed) {
    if (!core<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API)) return "its EGL has no desktop OpenGL";
    const char* extensions = display_.text(EGL_EXTENSIONS);
    const bool surfaceless = allowed.surfaceless && has(extensions, "EGL_KHR_surfaceless_context");
    const bool no_config = allowed.no_config && has(extensions, "EGL_KHR_no_config_context");
    EGLConfig config = EGL_NO_CONFIG_KHR;
    if (!surfaceless || !no_config) {
      if (!choose_config(config)) return "it has no EGL config for OpenGL with a pixel buffer";
    }
    constexpr std::array<EGLint, 7> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                                4,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                5,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    context_ = core<decltype(eglCreateContext)>("eglCreateContext")(display_.get(), config, EGL_NO_CONTEXT,
                                                                    kAttributes.data());
    if (context_ == EGL_NO_CONTEXT) return failed("it has no OpenGL 4.5 core profile: eglCreateContext");
    return surfaceless ? std::string() : make_surface(config);
  }

  std::string make_current() override {
    core<decltype(eglBindAPI)>("eglBindAPI")(EGL_OPENGL_API);
    return bind(surface_, context_) ? std::string() : failed("eglMakeCurrent");
  }
  void release() override { bind(EGL_NO_SURFACE, EGL_NO_CONTEXT); }
  [[nodiscard]] Loader loader() const override {
    return core<decltype(eglGetProcAddress)>("eglGetProcAddress");
  }
  [[nodiscard]] std::string library() const override {
    return std::string("EGL ") + display_.text(EGL_VERSION) + ", " + display_.text(EGL_VENDOR);
  }

 private:
  bool choose_config(EGLConfig& config) const {
    constexpr std::array<EGLint, 5> kWanted{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                            EGL_OPENGL_BIT, EGL_NONE};
    EGLint count = 0;
    return core<decltype(eglChooseConfig)>("eglChooseConfig")(display_.get(), kWanted.data(), &config, 1,
                                                              &count) &&
           count > 0;
  }

  std::string make_surface(EGLConfig config) {
    constexpr std::array<EGLint, 5> kOnePixel{EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    surface_ = core<decltype(eglCreatePbufferSurface)>("eglCreatePbufferSurface")(display_.get(), config,
                                                                                  kOnePixel.data());
    return surface_ == EGL_NO_SURFACE ? failed("eglCreatePbufferSurface") : std::string();
  }

  bool bind(EGLSurface surface, EGLContext context) const {
    return core<decltype(eglMakeCurrent)>("eglMakeCurrent")(display_.get(), surface, surface, context) ==
           EGL_TRUE;
  }

  Display display_;
  EGLContext context_ = EGL_NO_CONTEXT;
  EGLSurface surface_ = EGL_NO_SURFACE;
};

}  // namespace

EglListing list_egl() {
  if (!library().loaded()) return {{}, library().failure() + kPackages};
  EglListing listing;
  const std::vector<EGLDeviceEXT> handles = egl_devices();
  for (std::size_t i = 0; i < handles.size(); ++i)
    listing.devices.push_back(described(handles[i], static_cast<int>(i)));
  if (has(client_extensions(), "EGL_MESA_platform_surfaceless"))
    listing.devices.push_back({.api = Api::kEgl, .place = "EGL surfaceless platform"});
  if (listing.devices.empty()) {
    listing.lacks =
        std::string("libEGL.so.1 has no driver that offers a device or the surfaceless platform") + kPackages;
  }
  return listing;
}

Opened open_egl(int egl_device, EglMeans allowed) {
  const EGLDisplay handle = display_of(egl_device);
  if (handle == EGL_NO_DISPLAY) return {nullptr, failed("eglGetPlatformDisplay")};
  std::optional<Display> display = Display::initialise(handle);
  if (!display) return {nullptr, failed("eglInitialize")};
  auto context = std::make_unique<EglContext>(*std::move(display));
  if (std::string failure = context->make(allowed); !failure.empty()) return {nullptr, std::move(failure)};
  return {std::move(context), {}};
}

}  // namespace gnomon::gl
