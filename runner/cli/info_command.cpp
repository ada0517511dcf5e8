// SPDX-License-Identifier: MIT
#include <OpenImageIO/oiioversion.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "engine.h"
#include "gnomon/compiler/compiler.h"

namespace gnomon::cli {

int run_command(const InfoArguments&, Console& console) {
  console.out << "gnomon            " << GNOMON_VERSION << "\n"
              << "shader library    " << console.shader_library << "\n"
              << "glslang           " << compiler::glslang_version() << "\n"
              << "OpenImageIO       " << OIIO_VERSION_STRING << "\n"
              << "nlohmann-json     " << NLOHMANN_JSON_VERSION_MAJOR << "." << NLOHMANN_JSON_VERSION_MINOR
              << "." << NLOHMANN_JSON_VERSION_PATCH << "\n"
              << "back end cpu      the double-precision oracle, no OpenGL\n";
  if (!std::filesystem::exists(console.shader_library)) {
    return report(console, {{.file = console.shader_library,
                             .message = "the shader library is missing here",
                             .failure = Failure::kMachine}});
  }
  Engine engine({.shader_library = console.shader_library});
  const Result<const gl::Info*> info = engine.gl_info();
  if (!info) return report(console, info.diagnostics());
  console.out << "back end egl      " << (*info)->backend << ", EGL " << (*info)->egl << "\n"
              << "renderer          " << (*info)->renderer << "\n"
              << "vendor            " << (*info)->vendor << "\n"
              << "OpenGL            " << (*info)->version << "\n"
              << "GLSL              " << (*info)->shading_language << "\n"
              << "largest map       " << (*info)->max_texture_size << " samples a side\n";
  return 0;
}

}  // namespace gnomon::cli
