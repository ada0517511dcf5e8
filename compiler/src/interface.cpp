// SPDX-License-Identifier: MIT
#include <glslang/MachineIndependent/localintermediate.h>
#include <glslang/Public/ShaderLang.h>

#include <algorithm>
#include <tuple>

#include "inspect.h"

namespace gnomon::compiler {
namespace {

using glslang::TObjectReflection;
using glslang::TQualifier;
using glslang::TType;

std::optional<int> location_of(const TType& type) {
  const TQualifier& qualifier = type.getQualifier();
  if (!qualifier.hasLocation()) return std::nullopt;
  return static_cast<int>(qualifier.layoutLocation);
}

std::optional<int> set_of(const TType& type, const Target& target) {
  if (target.rules != Rules::kVulkan) return std::nullopt;
  const TQualifier& qualifier = type.getQualifier();
  return qualifier.hasSet() ? static_cast<int>(qualifier.layoutSet) : 0;
}

std::optional<int> binding_of(const TType& type) {
  const TQualifier& qualifier = type.getQualifier();
  if (!qualifier.hasBinding()) return std::nullopt;
  return static_cast<int>(qualifier.layoutBinding);
}

int array_size_of(const TType& type) {
  return type.isSizedArray() ? type.getOuterArraySize() : 0;
}

// "vec3" of a vec3[4].
std::string element_name(const TType& type) {
  if (!type.isArray()) return read_type(type).name;
  return read_type(TType(type, 0)).name;
}

Variable read_variable(const TObjectReflection& object) {
  const TType& type = *object.getType();
  return {.name = object.name,
          .type = element_name(type),
          .array_size = array_size_of(type),
          .location = location_of(type)};
}

Variable read_uniform(const TObjectReflection& object, const Target& target) {
  Variable variable = read_variable(object);
  const TType& type = *object.getType();
  if (!type.isOpaque()) return variable;
  variable.set = set_of(type, target);
  variable.binding = binding_of(type);
  return variable;
}

Block read_block(const TObjectReflection& object, bool is_storage, const Target& target) {
  const TType& type = *object.getType();
  return {.name = object.name,
          .is_storage = is_storage,
          .size = object.size,
          .set = set_of(type, target),
          .binding = binding_of(type)};
}

Member read_member(const TObjectReflection& object) {
  const TType& type = *object.getType();
  return {.name = object.name,
          .type = element_name(type),
          .offset = object.offset,
          .array_size = array_size_of(type),
          .array_stride = object.arrayStride};
}

void sort_by_location(std::vector<Variable>& variables) {
  std::ranges::sort(variables, [](const Variable& a, const Variable& b) {
    // Those without a location come last.
    return std::tuple(!a.location.has_value(), a.location, a.name) <
           std::tuple(!b.location.has_value(), b.location, b.name);
  });
}

class InterfaceReader {
 public:
  InterfaceReader(glslang::TProgram& program, const Target& target) : program_(program), target_(target) {}

  void read_uniforms(Reflection& into) {
    for (int i = 0; i < program_.getNumUniformBlocks(); ++i)
      into.blocks.push_back(read_block(program_.getUniformBlock(i), false, target_));
    const auto uniform_blocks = static_cast<int>(into.blocks.size());
    for (int i = 0; i < program_.getNumBufferBlocks(); ++i)
      into.blocks.push_back(read_block(program_.getBufferBlock(i), true, target_));
    for (int i = 0; i < program_.getNumUniformVariables(); ++i) {
      const TObjectReflection& object = program_.getUniform(i);
      if (object.index >= 0 && object.index < uniform_blocks) {
        into.blocks[static_cast<size_t>(object.index)].members.push_back(read_member(object));
      } else {
        auto& list = object.getType()->isOpaque() ? into.textures : into.uniforms;
        list.push_back(read_uniform(object, target_));
      }
    }
    for (int i = 0; i < program_.getNumBufferVariables(); ++i) {
      const TObjectReflection& object = program_.getBufferVariable(i);
      const auto block = static_cast<size_t>(uniform_blocks + object.index);
      if (object.index >= 0 && block < into.blocks.size())
        into.blocks[block].members.push_back(read_member(object));
    }
  }

  void read_inputs_and_outputs(Reflection& into) {
    for (int i = 0; i < program_.getNumPipeInputs(); ++i)
      into.inputs.push_back(read_variable(program_.getPipeInput(i)));
    for (int i = 0; i < program_.getNumPipeOutputs(); ++i)
      into.outputs.push_back(read_variable(program_.getPipeOutput(i)));
    sort_by_location(into.inputs);
    sort_by_location(into.outputs);
  }

 private:
  glslang::TProgram& program_;
  const Target& target_;
};

}  // namespace

Reflection read_interface(glslang::TProgram& program, Stage stage, const Target& target) {
  Reflection reflection{.target = target.name, .stage = stage};
  // IntermediateIO: inputs and outputs of a single stage, whichever it is.
  program.buildReflection(EShReflectionStrictArraySuffix | EShReflectionIntermediateIO |
                          EShReflectionSeparateBuffers | EShReflectionAllBlockVariables |
                          EShReflectionUnwrapIOBlocks);
  InterfaceReader reader(program, target);
  reader.read_uniforms(reflection);
  reader.read_inputs_and_outputs(reflection);
  std::ranges::sort(reflection.uniforms, {}, &Variable::name);
  std::ranges::sort(reflection.textures, {}, &Variable::name);
  std::ranges::sort(reflection.blocks, {}, &Block::name);
  for (Block& block : reflection.blocks) std::ranges::stable_sort(block.members, {}, &Member::offset);
  if (stage == Stage::kCompute) {
    for (int dimension = 0; dimension < 3; ++dimension)
      reflection.local_size.push_back(static_cast<int>(program.getLocalSize(dimension)));
  }
  return reflection;
}

}  // namespace gnomon::compiler
