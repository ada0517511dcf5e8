// SPDX-License-Identifier: MIT
#include "testing/gpu_calls.h"

#include <unistd.h>

#include <cstddef>
#include <filesystem>
#include <fstream>

#include "gl/draw.h"
#include "gl/texture.h"
#include "gnomon/compiler/modules.h"

namespace gnomon::modules {
namespace {

// A texel holds four scalars.
int texels(std::size_t scalars) {
  return static_cast<int>((scalars + 3) / 4);
}

// Each pixel makes one whole call and writes four scalars of its answer.
std::string program_text(const ModuleFunction& function, const std::vector<compiler::Module>& modules) {
  std::string text = "#include <gnomon/host/r32f.glsl>\n#include <gnomon/host/literal_extrema_rg32f.glsl>\n";
  // MapModules::light_nearness.
  text +=
      "float gnomon_host_light_nearness(ivec2 texel, int cascade) {\n"
      "  return float((texel.x * 7 + texel.y * 13 + cascade * 29) & 63) / 64.0;\n}\n";
  for (const compiler::Module& module : modules) {
    if (!module.defines_host()) text += "#include <gnomon/" + module.name + ".glsl>\n";
  }
  const std::string parts = std::to_string(texels(function.results.size()));
  const std::string stride = std::to_string(texels(static_cast<std::size_t>(function.arguments)));
  text += "uniform sampler2D u_arguments;\nlayout(location = 0) out vec4 o_results;\n";
  text += "float argument(int i) {\n  ivec2 pixel = ivec2(gl_FragCoord.xy);\n";
  text += "  return texelFetch(u_arguments, ivec2(pixel.x / " + parts + " * " + stride +
          " + i / 4, pixel.y), 0)[i % 4];\n}\n";
  text += "void main() {\n" + function.glsl;
  text += "  int part = int(gl_FragCoord.x) % " + parts + ";\n  o_results = vec4(0.0);\n";
  for (std::size_t i = 0; i < function.results.size(); ++i) {
    text += "  if (part == " + std::to_string(i / 4) + ") o_results[" + std::to_string(i % 4) +
            "] = " + function.results[i] + ";\n";
  }
  return text + "}\n";
}

// Rows of `from` scalars become rows of `to`, cut off or filled up with zeros.
std::vector<float> with_stride(std::span<const float> values, std::size_t from, std::size_t to) {
  std::vector<float> result(values.size() / from * to);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (i % to < from) result[i] = values[i / to * from + i % to];
  }
  return result;
}

Result<const technique::CachedProgram*> program_of(technique::ProgramCache& programs,
                                                   const std::string& library,
                                                   const ModuleFunction& function) {
  const auto modules = compiler::list_modules(library);
  if (!modules) return modules.diagnostics();
  const auto file = std::filesystem::temp_directory_path() /
                    ("gnomon-" + std::to_string(::getpid()) + "-" + function.name + ".frag");
  std::ofstream(file) << program_text(function, *modules);
  auto program = programs.get(file.string());
  std::filesystem::remove(file);
  return program;
}

}  // namespace

Result<std::vector<float>> call_on_gpu(technique::ProgramCache& programs, const technique::Pyramid& map,
                                       const std::string& library, const ModuleFunction& function, int calls,
                                       std::span<const float> arguments) {
  const auto program = program_of(programs, library, function);
  if (!program) return program.diagnostics();
  const auto given = static_cast<std::size_t>(function.arguments);
  const int rows = calls / kCallsPerRow;
  auto in = gl::Texture::create(gl::Format::kRgba32F, {kCallsPerRow * texels(given), rows});
  if (!in) return in.diagnostics();
  in->upload(with_stride(arguments, given, static_cast<std::size_t>(texels(given)) * 4));
  const int parts = texels(function.results.size());
  auto out = gl::Texture::create(gl::Format::kRgba32F, {kCallsPerRow * parts, rows});
  if (!out) return out.diagnostics();
  const Result<Done> drawn = gl::draw({.program = &(*program)->program,
                                       .uniforms = {},
                                       .samplers = {{.name = "u_arguments", .texture = &in.value()},
                                                    {.name = "gnomon_heights", .texture = &map.heights},
                                                    {.name = "gnomon_extrema",
                                                     .texture = &map.extrema,
                                                     .last_level = map.extrema.levels() - 1},
                                                    {.name = "gnomon_literal_extrema",
                                                     .texture = &map.literal_extrema.value(),
                                                     .last_level = map.literal_extrema->levels() - 1}},
                                       .target = &out.value()});
  if (!drawn) return drawn.diagnostics();
  return with_stride(out->download(), static_cast<std::size_t>(parts) * 4, function.results.size());
}

}  // namespace gnomon::modules
