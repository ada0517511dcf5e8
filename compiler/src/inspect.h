// SPDX-License-Identifier: MIT
// Reads what a shader is made of off glslang's syntax tree.
#pragma once

#include "shader.h"

class TIntermNode;
namespace glslang {
class TProgram;
class TType;
}  // namespace glslang

namespace gnomon::compiler {

/// Fills in has_main, defined, undefined.
void find_functions(TIntermNode& root, Shader& shader);

/// Lines of the loops that are not bounded in the sense of build(), in the order of the text.
[[nodiscard]] std::vector<int> find_unbounded_loops(TIntermNode& root);

/// Takes a type apart.
[[nodiscard]] Type read_type(const glslang::TType& type);

/// Inputs, outputs, uniforms, textures, blocks and the size of a work group of a linked program.
[[nodiscard]] Reflection read_interface(glslang::TProgram& program, Stage stage, const Target& target);

}  // namespace gnomon::compiler
