// SPDX-License-Identifier: MIT
// Reads what a shader is made of off glslang's syntax tree.
#pragma once

#include "declarations.h"
#include "shader.h"

class TIntermNode;
namespace glslang {
class TIntermediate;
class TType;
}  // namespace glslang

namespace gnomon::compiler {

/// Fills in has_main, defined, undefined.
void find_functions(TIntermNode& root, Shader& shader);

/// Lines of the loops that are not bounded in the sense of build(), in the order of the text.
[[nodiscard]] std::vector<int> find_unbounded_loops(TIntermNode& root);

/// The first loop or condition that is nested too deeply to be compiled in reasonable time.
[[nodiscard]] std::optional<Message> find_deep_nesting(TIntermNode& root);

/// The first uniform or buffer that has too many members to be listed, each array element counted, or more
/// bytes than an int counts.
[[nodiscard]] std::optional<Message> find_oversized_uniform(TIntermNode& root, DeclarationLines& lines);

/// Takes a type apart.
[[nodiscard]] Type read_type(const glslang::TType& type);

/// The name of a type without the dimensions of an array: "vec3" for vec3[4][2].
[[nodiscard]] std::string element_name(const glslang::TType& type);

/// What passes between stages without a location, in code that is to be SPIR-V: glslang would number it by
/// its place in this stage alone, and the stage on the other side otherwise.
[[nodiscard]] std::vector<std::string> find_unnumbered(const glslang::TIntermediate& code, Stage stage);

/// Elements of all dimensions of an array; 0: no array, or one without a size.
[[nodiscard]] int array_size_of(const glslang::TType& type);

/// Fills in `reached` and `interface` from the linked code of a stage: active inputs, outputs, uniforms,
/// textures and blocks, constants, and the size of a work group.
void read_interface(const glslang::TIntermediate& code, Stage stage, const Target& target, Shader& shader);

}  // namespace gnomon::compiler
