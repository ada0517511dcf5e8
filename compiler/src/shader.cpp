// SPDX-License-Identifier: MIT
#include "shader.h"

#include <fmt/format.h>
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <algorithm>
#include <string_view>

#include "excess.h"
#include "inspect.h"
#include "log.h"
#include "near_miss.h"
#include "text.h"
#include "uniforms.h"

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

// Uniforms outside of blocks, bindings and locations may be left open in the source: glslang fills them in.
EShMessages set_rules(glslang::TShader& unit, Stage stage, Rules rules) {
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
  unit.setGlobalUniformBlockName("gnomon_uniforms");
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
    messages = set_rules(shader, stage, rules);
  }

  const char* string;
  int length;
  glslang::TShader shader;
  EShMessages messages;
};

// The first in the text; the names are in no order of it.
std::optional<Message> first_unnumbered(const std::string& text, const std::vector<std::string>& names) {
  std::optional<Message> first;
  for (const std::string& name : names) {
    const int line = line_of_word(text, name);
    if (first && first->line <= line) continue;
    first = Message{
        line, fmt::format("'{}': passes between stages without a location, by which SPIR-V matches the two "
                          "sides: write layout(location = N) in both",
                          name)};
  }
  return first;
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
  shader.error = find_oversized_uniform(root);
  if (!shader.error) shader.error = find_deep_nesting(root);
  if (shader.error) return shader;
  find_functions(root, shader);
  shader.unbounded_loops = find_unbounded_loops(root);
  if (!shader.has_main) return shader;
  if (target.rules != Rules::kOpenGl)
    shader.error = first_unnumbered(text, find_unnumbered(*unit.getIntermediate(), stage));
  if (shader.error) return shader;
  glslang::TProgram program;
  program.addShader(&unit);
  const bool linked = program.link(messages) && (target.rules == Rules::kOpenGl || program.mapIO());
  if (!linked) {
    shader.error = read_link_log(program.getInfoLog(), text, shader);
    return shader;
  }
  shader.interface = read_interface(*program.getIntermediate(language_of(stage)), stage, target);
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
