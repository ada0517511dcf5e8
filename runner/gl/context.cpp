// SPDX-License-Identifier: MIT
#include "gl/context.h"

#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <utility>

#include "gl/choice.h"
#include "gl/egl.h"
#include "gl/native.h"
#include "gl/osmesa.h"

namespace gnomon::gl {
namespace {

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "unknown";
}

long limit_of(GLenum name) {
  GLint64 value = 0;
  glGetInteger64v(name, &value);
  return static_cast<long>(value);
}

Info read_info() {
  Info info;
  info.vendor = text_of(GL_VENDOR);
  info.renderer = text_of(GL_RENDERER);
  info.version = text_of(GL_VERSION);
  info.shading_language = text_of(GL_SHADING_LANGUAGE_VERSION);
  info.max_texture_size = static_cast<int>(limit_of(GL_MAX_TEXTURE_SIZE));
  std::array<GLint, 2> viewport{};
  glGetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
  info.limits = {{"image, pixels a side", std::min(viewport[0], viewport[1])},
                 {"texture array, layers", limit_of(GL_MAX_ARRAY_TEXTURE_LAYERS)},
                 {"texture buffer, texels", limit_of(GL_MAX_TEXTURE_BUFFER_SIZE)},
                 {"storage block, bytes", limit_of(GL_MAX_SHADER_STORAGE_BLOCK_SIZE)}};
  return info;
}

/// A device that is not Mesa's software device may still end there: a display adapter without a GPU.
bool draws_by_cpu(const std::string& renderer) {
  const auto named = [&](const char* name) { return renderer.find(name) != std::string::npos; };
  return named("llvmpipe") || named("softpipe") || named("swrast") || named("Software Rasterizer");
}

Found list_devices() {
  EglListing egl = list_egl();
  Found found{
      .devices = std::move(egl.devices), .egl_lacks = std::move(egl.lacks), .osmesa_lacks = osmesa_lacks()};
  if (found.osmesa_lacks.empty())
    found.devices.push_back({.api = Api::kOsmesa, .place = "OSMesa", .software = true});
  return found;
}

Opened open_native(const Device& device) {
  return device.api == Api::kEgl ? open_egl(device.egl_device) : open_osmesa();
}

}  // namespace

struct Context::State {
  std::unique_ptr<Native> native;
  GLuint vertex_array = 0;
  Info info;

  explicit State(std::unique_ptr<Native> made) : native(std::move(made)) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  /// Leaves the context current that was so, unless it is this one.
  ~State() {
    State* before = current == this ? nullptr : current;
    if (make_current().empty() && vertex_array != 0) glDeleteVertexArrays(1, &vertex_array);
    leave();
    native.reset();
    back_to(before);
  }

  /// Empty on success, else what failed. The table of GL functions is one for the process: it is loaded anew.
  std::string make_current() {
    if (current == this) return {};
    leave();
    if (std::string failure = native->make_current(); !failure.empty()) return failure;
    current = this;
    return gladLoadGL(native->loader()) ? std::string() : "the GL functions cannot be loaded";
  }

  /// Makes the context current that was so before, where there was one.
  static void back_to(State* before) {
    if (!before || !before->make_current().empty()) leave();
  }

  static void leave() {
    if (current) current->native->release();
    current = nullptr;
  }

  /// A context on the device, current; null where there is none. Writes into the device what became known.
  static std::unique_ptr<State> open(Device& device) {
    Opened opened = open_native(device);
    device.failure = std::move(opened.failure);
    if (!opened.native) return nullptr;
    auto state = std::make_unique<State>(std::move(opened.native));
    device.failure = state->make_current();
    if (!device.failure.empty()) return nullptr;
    state->info = read_info();
    state->info.library = state->native->library();
    device.renderer = state->info.renderer;
    device.version = state->info.version;
    device.software = draws_by_cpu(device.renderer);
    // The core profile draws nothing without a vertex array, and ours needs no attributes: one, bound for
    // good.
    glCreateVertexArrays(1, &state->vertex_array);
    glBindVertexArray(state->vertex_array);
    return state;
  }

  /// Tries the devices whose name is not known yet.
  static void name_all(Found& found) {
    for (Device& device : found.devices) {
      if (device.renderer.empty() && device.failure.empty()) open(device);
    }
  }

  static thread_local State* current;
};

thread_local Context::State* Context::State::current = nullptr;

Result<Context> Context::create(const Request& request) {
  State* const before = State::current;
  Found found = list_devices();
  if (asks_by_name(request)) State::name_all(found);
  // A device may fail, or turn out to be software, when it is tried: then the choice is made again with what
  // is known by then. Each device changes twice at most.
  for (;;) {
    Result<Choice> choice = choose(found, request);
    if (!choice) {
      State::name_all(found);  // the message lists them
      State::back_to(before);
      return choose(found, request).diagnostics();
    }
    std::unique_ptr<State> state = State::open(found.devices[choice->device]);
    if (!state) continue;
    const Result<Choice> again = choose(found, request);
    if (!again || again->device != choice->device) continue;
    state->info.device = found.devices[again->device];
    state->info.number = again->device;
    state->info.reason = again->reason;
    return Context(std::move(state));
  }
}

Found Context::survey() {
  State* const before = State::current;
  Found found = list_devices();
  for (Device& device : found.devices) State::open(device);
  State::back_to(before);
  return found;
}

Context::Context(std::unique_ptr<State> state) : state_(std::move(state)) {}
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;
Context::~Context() = default;

Result<Done> Context::make_current() {
  if (!state_) return Done{};
  const std::string failure = state_->make_current();
  if (failure.empty()) return Done{};
  return Diagnostic{.message = "the OpenGL context cannot be used any more: " + failure,
                    .failure = Failure::kMachine};
}

const Info& Context::info() const {
  return state_->info;
}

}  // namespace gnomon::gl
