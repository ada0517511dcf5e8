// SPDX-License-Identifier: MIT
#include "spirv.h"

#include <spirv-tools/libspirv.hpp>
#include <spirv_cross/spirv_hlsl.hpp>
#include <spirv_cross/spirv_msl.hpp>

namespace gnomon::compiler {
namespace {

std::string to_hlsl(const std::uint32_t* words, size_t count) {
  spirv_cross::CompilerHLSL compiler(words, count);
  spirv_cross::CompilerHLSL::Options options = compiler.get_hlsl_options();
  options.shader_model = 50;
  compiler.set_hlsl_options(options);
  return compiler.compile();
}

std::string to_msl(const std::uint32_t* words, size_t count) {
  spirv_cross::CompilerMSL compiler(words, count);
  spirv_cross::CompilerMSL::Options options = compiler.get_msl_options();
  options.msl_version = spirv_cross::CompilerMSL::Options::make_msl_version(2, 1);
  compiler.set_msl_options(options);
  return compiler.compile();
}

}  // namespace

std::optional<std::string> defect_of(std::span<const std::uint32_t> spirv, Rules rules) {
  spvtools::SpirvTools tools(rules == Rules::kVulkan ? SPV_ENV_VULKAN_1_0 : SPV_ENV_OPENGL_4_5);
  std::string defect;
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    if (defect.empty()) defect = message;
  });
  if (tools.Validate(spirv.data(), spirv.size())) return std::nullopt;
  return defect.empty() ? "the module is not valid" : defect;
}

Translation translate(std::span<const std::uint32_t> spirv, Format format) {
  try {
    return {.text = format == Format::kHlsl ? to_hlsl(spirv.data(), spirv.size())
                                            : to_msl(spirv.data(), spirv.size())};
  } catch (const std::exception& refusal) {  // its way to say that the language has no such thing
    return {.text = {}, .failure = refusal.what()};
  }
}

}  // namespace gnomon::compiler
