// SPDX-License-Identifier: MIT
#include "shader.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <string_view>

#include "declarations.h"
#include "excess.h"
#include "inspect.h"
#include "lacks.h"
#include "log.h"
#include "near_miss.h"
#include "numbering.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

// glslang wants this once in a process, before anything else.
void initialize_glslang() {
  static const struct Process {
    Process() { glslang::InitializeProcess(); }
    ~Process() { glslang::FinalizeProcess(); }
  } process;
}

EShLanguage language_of(Stage stage) {
  switch (stage) {
    case Stage::kVertex:
      return EShLangVertex;
    case Stage::kGeometry:
      return EShLangGeometry;
    case Stage::kCompute:
      return EShLangCompute;
    case Stage::kFragment:
      break;
  }
  return EShLangFragment;
}

// Of the block that uniforms outside of blocks become: one that the text does not use.
std::string name_of_uniforms(std::string_view text) {
  const std::string name = "gnomon_uniforms";
  if (text.find(name) == text.npos) return name;
  int number = 2;
  while (text.find(name + std::to_string(number)) != text.npos) ++number;
  return name + std::to_string(number);
}

// Uniforms outside of blocks, bindings and locations may be left open in the source: number() fills them in.
EShMessages set_rules(glslang::TShader& unit, const std::string& text, Stage stage, Rules rules) {
  // For plain OpenGL none of this may be called: it makes glslang accept less.
  if (rules == Rules::kOpenGl) return EShMsgDefault;
  const bool vulkan = rules == Rules::kVulkan;
  const glslang::EShClient client = vulkan ? glslang::EShClientVulkan : glslang::EShClientOpenGL;
  unit.setEnvInput(glslang::EShSourceGlsl, language_of(stage), client, 100);
  unit.setEnvClient(client, vulkan ? glslang::EShTargetVulkan_1_0 : glslang::EShTargetOpenGL_450);
  unit.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  unit.setAutoMapBindings(true);
  unit.setAutoMapLocations(true);
  if (!vulkan) return EShMsgSpvRules;
  unit.setEnvInputVulkanRulesRelaxed();
  unit.setGlobalUniformBlockName(name_of_uniforms(text).c_str());
  return static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
}

std::vector<std::uint32_t> to_spirv(const glslang::TProgram& program, Stage stage) {
  std::vector<std::uint32_t> words;
  glslang::SpvOptions options;
  options.disableOptimizer = true;  // it would fold sums of floats
  spv::SpvBuildLogger ignored;      // what it says of valid shaders concerns SPIR-V extensions only
  glslang::GlslangToSpv(*program.getIntermediate(language_of(stage)), words, &ignored, &options);
  return words;
}

int line_of(const std::vector<Function>& functions, std::string_view name) {
  const auto found = std::ranges::find(functions, name, &Function::name);
  return found == functions.end() ? 0 : found->line;
}

// The name before '(' of the mangled one that follows `marker` in the log, empty where there is none.
std::string name_after(std::string_view log, std::string_view marker) {
  const size_t at = log.find(marker);
  if (at == log.npos) return {};
  const std::string line = first_line(log.substr(at + marker.size()));
  return line.substr(0, line.find('('));
}

// The linker names functions, but no lines.
Message read_link_log(std::string_view log, const std::string& text, const Shader& shader) {
  if (const std::string name = name_after(log, "No function definition (body) found:"); !name.empty()) {
    return undefined_function(name, text, shader);
  }
  if (const std::string name = name_after(log, "Recursion detected:"); !name.empty()) {
    return {line_of(shader.defined, name), "function '" + name +
                                               "' calls itself, directly or through others: GLSL has "
                                               "no recursion, write a loop with a bound"};
  }
  std::string message = first_line(log);
  for (const std::string_view prefix : {"ERROR: ", "Linking "}) {
    if (message.starts_with(prefix)) message.erase(0, prefix.size());
  }
  return {1, message};
}

constexpr int kVersionWithoutDirective = 110;  // never used: the text has a #version

// A text for glslang, which keeps pointers to what it is given.
struct Unit {
  Unit(const std::string& text, Stage stage, Rules rules)
      : string(text.data()), length(static_cast<int>(text.size())), shader(language_of(stage)) {
    shader.setStringsWithLengths(&string, &length, 1);
    messages = set_rules(shader, text, stage, rules);
  }

  const char* string;
  int length;
  glslang::TShader shader;
  EShMessages messages;
};

// The first in the text; the names are in no order of it.
std::optional<Message> first_unnumbered(const std::vector<std::string>& names, DeclarationLines& lines) {
  std::optional<Message> first;
  for (const std::string& name : names) {
    const int line = lines.of(name);
    if (first && first->line <= line) continue;
    first = Message{
        line, fmt::format("'{}': passes between stages without a location, by which SPIR-V matches the two "
                          "sides: write layout(location = N) in both",
                          name)};
  }
  return first;
}

// Numbers what is open, and says what the target cannot bind.
void judge(glslang::TIntermediate& code, Stage stage, const Target& target, DeclarationLines& lines,
           Shader& shader) {
  Numbered numbered = number(code, stage, target, lines);
  shader.objection = std::move(numbered.objection);
  shader.resources = std::move(numbered.resources);
  shader.outputs = numbered.outputs;
  if (auto lack = find_lack(code, target, lines)) shader.objection = std::move(lack);
  if (shader.objection) return;
  if (auto wrong = find_binding_beyond(shader.resources, shader.outputs, target))
    shader.objection = Message{lines.of(wrong->name), wrong->message};
}

// SPIR-V has no number for push constants, HLSL and MSL have.
void bind_push_constants(Shader& shader) {
  for (Block& block : shader.interface.blocks) {
    const auto found = std::ranges::find(shader.resources, block.name, &Resource::name);
    if (block.kind == BlockKind::kPushConstant && found != shader.resources.end())
      block.binding = found->binding;
  }
}

// What glslang must not be given.
std::optional<Message> find_unbearable(const std::string& text, Stage stage, const Target& target) {
  if (auto excess = find_excess(text)) return excess;
  const std::string preprocessed = preprocess(text, stage, target);
  if (auto depth = find_depth(preprocessed, target.rules != Rules::kOpenGl)) return depth;
  if (target.rules != Rules::kVulkan) return std::nullopt;
  return find_uniform_collision(preprocessed);
}

}  // namespace

std::string preprocess(const std::string& text, Stage stage, const Target& target) {
  initialize_glslang();
  Unit unit(text, stage, target.rules);
  std::string preprocessed;
  glslang::TShader::ForbidIncluder no_includes;
  unit.shader.preprocess(GetDefaultResources(), kVersionWithoutDirective, ENoProfile, false, false,
                         unit.messages, &preprocessed, no_includes);
  return preprocessed;
}

Shader compile(const std::string& text, Stage stage, const Target& target) {
  initialize_glslang();
  Shader shader;
  shader.error = find_unbearable(text, stage, target);
  if (shader.error) return shader;
  Unit source(text, stage, target.rules);
  glslang::TShader& unit = source.shader;
  const EShMessages messages = source.messages;
  const bool parsed = unit.parse(GetDefaultResources(), kVersionWithoutDirective, false, messages);
  Log log = read_log(unit.getInfoLog(), text);
  shader.warnings = std::move(log.warnings);
  if (!parsed) {
    shader.error = log.error ? *log.error : Message{1, first_line(unit.getInfoLog())};
    return shader;
  }

  TIntermNode& root = *unit.getIntermediate()->getTreeRoot();
  DeclarationLines lines(text, stage, target);
  shader.error = find_oversized_uniform(root, lines);
  if (!shader.error) shader.error = find_deep_nesting(root);
  if (shader.error) return shader;
  find_functions(root, shader);
  shader.unbounded_loops = find_unbounded_loops(root);
  if (!shader.has_main) return shader;
  if (target.rules != Rules::kOpenGl)
    shader.error = first_unnumbered(find_unnumbered(*unit.getIntermediate(), stage), lines);
  if (shader.error) return shader;
  judge(*unit.getIntermediate(), stage, target, lines, shader);
  glslang::TProgram program;
  program.addShader(&unit);
  if (!program.link(messages)) {
    shader.error = read_link_log(program.getInfoLog(), text, shader);
    return shader;
  }
  read_interface(*program.getIntermediate(language_of(stage)), stage, target, shader);
  bind_push_constants(shader);
  if (target.rules != Rules::kOpenGl) shader.spirv = to_spirv(program, stage);
  return shader;
}

std::optional<std::string> defect_of_hlsl(const std::string& text, Stage stage) {
  initialize_glslang();
  glslang::TShader unit(language_of(stage));
  const char* const string = text.c_str();
  unit.setStrings(&string, 1);
  unit.setEnvInput(glslang::EShSourceHlsl, language_of(stage), glslang::EShClientVulkan, 100);
  unit.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_0);
  unit.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_0);
  unit.setEntryPoint("main");
  constexpr auto messages = static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules);
  if (unit.parse(GetDefaultResources(), 500, false, messages)) return std::nullopt;
  return first_line(unit.getInfoLog());
}

std::string glslang_version() {
  const glslang::Version version = glslang::GetVersion();
  return fmt::format("{}.{}.{}", version.major, version.minor, version.patch);
}

}  // namespace gnomon::compiler
