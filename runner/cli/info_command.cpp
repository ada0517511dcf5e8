// SPDX-License-Identifier: MIT
#include <OpenImageIO/oiioversion.h>
#include <fmt/format.h>

#include <CLI/Version.hpp>
#include <algorithm>
#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "ephemeris/sun_position.h"
#include "gl/choice.h"
#include "gl/context.h"
#include "gnomon/compiler/compiler.h"

namespace gnomon::cli {
namespace {

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("{:<18} {}\n", name, value);
}

/// A library whose version is three numbers.
std::string row(const std::string& name, int major, int minor, int patch) {
  return row(name, fmt::format("{}.{}.{}", major, minor, patch));
}

std::string versions() {
  return row("gnomon", GNOMON_VERSION) + row("glslang", compiler::glslang_version()) +
         row("SPIRV-Tools", compiler::spirv_tools_version()) +
         row("SPIRV-Cross", compiler::spirv_cross_version()) + row("OpenImageIO", OIIO_VERSION_STRING) +
         row("nlohmann-json", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
             NLOHMANN_JSON_VERSION_PATCH) +
         row("fmt", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100) +
         row("CLI11", CLI11_VERSION) + row("ERFA", ephemeris::library_version()) +
         row("GLM", fmt::format("{}.{}.{}.{}", GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH,
                                GLM_VERSION_REVISION));
}

/// "there", or what is missing.
std::string state_of(const gl::Found& found, gl::Api api, const std::string& lacks) {
  if (!lacks.empty()) return "absent: " + lacks;
  const auto count = std::count_if(found.devices.begin(), found.devices.end(), [&](const gl::Device& device) {
    return device.api == api && device.failure.empty();
  });
  return count == 0 ? "no device gives an OpenGL 4.5 context" : fmt::format("{} to choose from", count);
}

std::string backends(const gl::Found& found) {
  return row("back end egl", state_of(found, gl::Api::kEgl, found.egl_lacks)) +
         row("back end osmesa", state_of(found, gl::Api::kOsmesa, found.osmesa_lacks)) +
         row("back end cpu", "the double-precision oracle, no OpenGL");
}

/// What `auto` makes of each device that it does not take.
std::string devices(const gl::Found& found, const Result<gl::Choice>& chosen) {
  std::string text;
  for (std::size_t i = 0; i < found.devices.size(); ++i) {
    const gl::Device& device = found.devices[i];
    std::string line = gl::describe(found, i);
    if (device.failure.empty()) {
      line += ", OpenGL " + device.version;
      line += i == chosen->device ? "; taken by auto"
                                  : fmt::format("; works, but auto prefers device {}", chosen->device);
    }
    text += row("device", line);
  }
  return text;
}

std::string chosen_device(const gl::Info& info) {
  std::string text = row("auto takes", fmt::format("device {}: {}", info.number, info.reason)) +
                     row("library", info.library) + row("vendor", info.vendor) +
                     row("renderer", info.renderer) + row("OpenGL", info.version) +
                     row("GLSL", info.shading_language) +
                     row("largest map", fmt::format("{} samples a side", info.max_texture_size));
  for (const gl::Limit& limit : info.limits)
    text += row("limit", fmt::format("{}: {}", limit.what, limit.value));
  return text;
}

}  // namespace

int run_command(const InfoArguments&, Console& console) {
  const bool library = std::filesystem::exists(console.shader_library);
  console.out << versions() << row("shader library", console.shader_library) << std::flush;
  const gl::Found found = gl::Context::survey();
  const Result<gl::Choice> chosen = gl::choose(found, {});
  console.out << backends(found) << devices(found, chosen);
  Diagnostics missing;
  const Result<gl::Context> context = gl::Context::create();
  if (context) {
    console.out << chosen_device(context->info());
  } else {
    missing = context.diagnostics();
  }
  if (!library) {
    missing.push_back({.file = console.shader_library,
                       .message = "the shader library is missing here",
                       .failure = Failure::kMachine});
  }
  return report(console, missing);
}

}  // namespace gnomon::cli
