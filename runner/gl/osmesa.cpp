// SPDX-License-Identifier: MIT
#include "gl/osmesa.h"

#include <array>
#include <memory>

#include "gl/library.h"

namespace gnomon::gl {
namespace {

// The interface of GL/osmesa.h, which has not changed since 2015. The header itself brings <GL/gl.h>, which
// does not go with the loader's.
constexpr int kRgba = 0x1908;
constexpr int kUnsignedByte = 0x1401;
constexpr int kFormat = 0x22;
constexpr int kProfile = 0x33;
constexpr int kCoreProfile = 0x34;
constexpr int kMajorVersion = 0x36;
constexpr int kMinorVersion = 0x37;
using CreateContext = void*(const int* attributes, void* shared);
using MakeCurrent = unsigned char(void* context, void* buffer, int type, int width, int height);
using DestroyContext = void(void* context);
using GetProcAddress = void (*(const char* name))();

const Library& library() {
  static const Library opened{"libOSMesa.so.8", "libOSMesa.so.6"};
  return opened;
}

class OsmesaContext final : public Native {
 public:
  explicit OsmesaContext(void* context) : context_(context) {}
  ~OsmesaContext() override { gl::library().get<DestroyContext>("OSMesaDestroyContext")(context_); }

  std::string make_current() override {
    return bind(context_, pixel_.data()) ? "" : "OSMesaMakeCurrent failed";
  }
  void release() override { bind(nullptr, nullptr); }
  [[nodiscard]] Loader loader() const override {
    return gl::library().get<GetProcAddress>("OSMesaGetProcAddress");
  }
  [[nodiscard]] std::string library() const override { return "OSMesa"; }

 private:
  static bool bind(void* context, void* buffer) {
    return gl::library().get<MakeCurrent>("OSMesaMakeCurrent")(context, buffer, kUnsignedByte, 1, 1) != 0;
  }

  void* context_;
  // The default framebuffer, which nothing is drawn to: OSMesa demands one.
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace

std::string osmesa_lacks() {
  const std::string package = "; the Debian package libosmesa6 brings it";
  if (!library().loaded()) return library().failure() + package;
  for (const char* name :
       {"OSMesaCreateContextAttribs", "OSMesaMakeCurrent", "OSMesaDestroyContext", "OSMesaGetProcAddress"}) {
    if (!library().get<void>(name)) return "libOSMesa has no " + std::string(name) + package;
  }
  return {};
}

Opened open_osmesa() {
  if (std::string failure = osmesa_lacks(); !failure.empty()) return {nullptr, std::move(failure)};
  const int attributes[] = {kFormat, kRgba, kProfile, kCoreProfile, kMajorVersion, 4, kMinorVersion, 5, 0};
  void* context = library().get<CreateContext>("OSMesaCreateContextAttribs")(attributes, nullptr);
  if (!context) return {nullptr, "it has no OpenGL 4.5 core profile"};
  return {std::make_unique<OsmesaContext>(context), {}};
}

}  // namespace gnomon::gl
