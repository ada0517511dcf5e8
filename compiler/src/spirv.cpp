// SPDX-License-Identifier: MIT
#include "spirv.h"

#include <fmt/format.h>
#include <spirv_cross/spirv_cross_c.h>

#include <spirv-tools/libspirv.hpp>
#include <spirv_cross/spirv_hlsl.hpp>
#include <spirv_cross/spirv_msl.hpp>

#include "log.h"

namespace gnomon::compiler {
namespace {

// Members of a block without an instance name are called after the block, not after a number:
// gnomon_uniforms_u_sun.
void name_instances(spirv_cross::Compiler& compiler) {
  const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
  for (const auto* list : {&resources.uniform_buffers, &resources.push_constant_buffers}) {
    for (const spirv_cross::Resource& block : *list) {
      if (compiler.get_name(block.id).empty())
        compiler.set_name(block.id, compiler.get_name(block.base_type_id) + "_data");
    }
  }
}

std::string to_hlsl(const std::uint32_t* words, size_t count) {
  spirv_cross::CompilerHLSL compiler(words, count);
  spirv_cross::CompilerHLSL::Options options = compiler.get_hlsl_options();
  options.shader_model = 50;
  compiler.set_hlsl_options(options);
  name_instances(compiler);
  return compiler.compile();
}

// Metal numbers buffers, textures and samplers apart: each takes the binding of the source. Push constants,
// which have none, take the last buffer.
void keep_bindings(spirv_cross::CompilerMSL& compiler) {
  constexpr std::uint32_t kLastBuffer = 30;
  const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
  const auto keep = [&](std::uint32_t set, std::uint32_t binding, std::uint32_t index) {
    spirv_cross::MSLResourceBinding kept;
    kept.stage = compiler.get_execution_model();
    kept.desc_set = set;
    kept.binding = binding;
    kept.msl_buffer = kept.msl_texture = kept.msl_sampler = index;
    compiler.add_msl_resource_binding(kept);
  };
  for (const auto* list :
       {&resources.uniform_buffers, &resources.storage_buffers, &resources.sampled_images,
        &resources.separate_images, &resources.separate_samplers, &resources.storage_images}) {
    for (const spirv_cross::Resource& resource : *list) {
      const std::uint32_t binding = compiler.get_decoration(resource.id, spv::DecorationBinding);
      keep(compiler.get_decoration(resource.id, spv::DecorationDescriptorSet), binding, binding);
    }
  }
  if (!resources.push_constant_buffers.empty())
    keep(spirv_cross::ResourceBindingPushConstantDescriptorSet,
         spirv_cross::ResourceBindingPushConstantBinding, kLastBuffer);
}

std::string to_msl(const std::uint32_t* words, size_t count) {
  spirv_cross::CompilerMSL compiler(words, count);
  spirv_cross::CompilerMSL::Options options = compiler.get_msl_options();
  options.msl_version = spirv_cross::CompilerMSL::Options::make_msl_version(2, 1);
  compiler.set_msl_options(options);
  keep_bindings(compiler);
  std::string text = compiler.compile();
  if (compiler.needs_buffer_size_buffer())
    throw spirv_cross::CompilerError(
        "length() of a storage buffer has no place in MSL: pass the length as a uniform");
  return text;
}

}  // namespace

std::optional<std::string> defect_of(std::span<const std::uint32_t> spirv, Rules rules) {
  spvtools::SpirvTools tools(rules == Rules::kVulkan ? SPV_ENV_VULKAN_1_0 : SPV_ENV_OPENGL_4_5);
  std::string defect;
  tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
    if (defect.empty()) defect = message;
  });
  if (tools.Validate(spirv.data(), spirv.size())) return std::nullopt;
  return defect.empty() ? "the module is not valid" : first_line(defect);
}

Translation translate(std::span<const std::uint32_t> spirv, Format format) {
  try {
    return {.text = format == Format::kHlsl ? to_hlsl(spirv.data(), spirv.size())
                                            : to_msl(spirv.data(), spirv.size())};
  } catch (const std::exception& refusal) {  // its way to say that the language has no such thing
    return {.text = {}, .failure = first_line(refusal.what())};
  }
}

std::string spirv_tools_version() {
  return spvSoftwareVersionString();
}

std::string spirv_cross_version() {
  return fmt::format("{}.{}.{}", SPVC_C_API_VERSION_MAJOR, SPVC_C_API_VERSION_MINOR,
                     SPVC_C_API_VERSION_PATCH);
}

}  // namespace gnomon::compiler
