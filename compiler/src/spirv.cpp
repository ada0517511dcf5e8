// SPDX-License-Identifier: MIT
#include "spirv.h"

#include <fmt/format.h>
#include <spirv_cross/spirv_cross_c.h>

#include <spirv-tools/libspirv.hpp>
#include <spirv_cross/spirv_hlsl.hpp>
#include <spirv_cross/spirv_msl.hpp>

#include "log.h"
#include "words.h"

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

// Names that are words of the other language get a `_`: it is by numbers that a host finds what it binds.
void rename_words(spirv_cross::Compiler& compiler, std::span<const std::uint32_t> spirv, Format format) {
  constexpr size_t kHeader = 5;
  for (size_t at = kHeader; at < spirv.size();) {
    const std::uint32_t length = spirv[at] >> 16;
    const std::uint32_t code = spirv[at] & 0xFFFFu;
    if (length == 0 || at + length > spirv.size()) return;
    const bool is_name = code == spv::OpName || code == spv::OpMemberName;
    const size_t text_at = at + (code == spv::OpName ? 2 : 3);
    if (is_name && text_at < at + length) {
      // Functions are called "f(vf3;", after their parameters.
      std::string name = reinterpret_cast<const char*>(&spirv[text_at]);
      name = name.substr(0, name.find('('));
      if (is_word_of(format, name) && code == spv::OpName) compiler.set_name(spirv[at + 1], name + "_");
      if (is_word_of(format, name) && code == spv::OpMemberName)
        compiler.set_member_name(spirv[at + 1], spirv[at + 2], name + "_");
    }
    at += length;
  }
}

// Leaves out resources that main() does not reach: they have no place. What passes between stages stays, for
// the stage on the other side.
void leave_out_unused(spirv_cross::Compiler& compiler) {
  auto used = compiler.get_active_interface_variables();
  const spirv_cross::ShaderResources all = compiler.get_shader_resources();
  for (const auto* list : {&all.stage_inputs, &all.stage_outputs}) {
    for (const spirv_cross::Resource& variable : *list) used.insert(variable.id);
  }
  for (const auto* list : {&all.builtin_inputs, &all.builtin_outputs}) {
    for (const spirv_cross::BuiltInResource& variable : *list) used.insert(variable.resource.id);
  }
  compiler.set_enabled_interface_variables(std::move(used));
}

std::string to_hlsl(std::span<const std::uint32_t> spirv, int push_constants) {
  spirv_cross::CompilerHLSL compiler(spirv.data(), spirv.size());
  spirv_cross::CompilerHLSL::Options options = compiler.get_hlsl_options();
  options.shader_model = 50;
  options.nonwritable_uav_texture_as_srv = true;  // shader model 5.0 loads from few formats otherwise
  compiler.set_hlsl_options(options);
  rename_words(compiler, spirv, Format::kHlsl);
  name_instances(compiler);
  // The whole of the push constants as one constant buffer.
  constexpr std::uint32_t kEnd = 1u << 30;
  compiler.set_root_constant_layouts({{0, kEnd, static_cast<std::uint32_t>(push_constants), 0}});
  leave_out_unused(compiler);
  return compiler.compile();
}

// Metal numbers buffers, textures and samplers apart: each takes its binding.
void keep_bindings(spirv_cross::CompilerMSL& compiler, int push_constants) {
  const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
  const auto keep = [&](std::uint32_t set, std::uint32_t binding, std::uint32_t index) {
    spirv_cross::MSLResourceBinding kept;
    kept.stage = compiler.get_execution_model();
    kept.desc_set = set;
    kept.binding = binding;
    kept.msl_buffer = kept.msl_texture = kept.msl_sampler = index;
    compiler.add_msl_resource_binding(kept);
  };
  for (const auto* list : {&resources.uniform_buffers, &resources.storage_buffers, &resources.sampled_images,
                           &resources.separate_images, &resources.separate_samplers,
                           &resources.storage_images, &resources.subpass_inputs}) {
    for (const spirv_cross::Resource& resource : *list) {
      const std::uint32_t binding = compiler.get_decoration(resource.id, spv::DecorationBinding);
      keep(compiler.get_decoration(resource.id, spv::DecorationDescriptorSet), binding, binding);
    }
  }
  keep(spirv_cross::ResourceBindingPushConstantDescriptorSet, spirv_cross::ResourceBindingPushConstantBinding,
       static_cast<std::uint32_t>(push_constants));
}

std::string to_msl(std::span<const std::uint32_t> spirv, int push_constants) {
  spirv_cross::CompilerMSL compiler(spirv.data(), spirv.size());
  spirv_cross::CompilerMSL::Options options = compiler.get_msl_options();
  options.msl_version = spirv_cross::CompilerMSL::Options::make_msl_version(2, 1);
  options.texture_buffer_native = true;  // else a texture of 4096 columns, which no host would guess
  compiler.set_msl_options(options);
  rename_words(compiler, spirv, Format::kMsl);
  leave_out_unused(compiler);
  keep_bindings(compiler, push_constants);
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

Translation translate(std::span<const std::uint32_t> spirv, Format format, int push_constants) {
  try {
    return {.text = format == Format::kHlsl ? to_hlsl(spirv, push_constants) : to_msl(spirv, push_constants)};
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
