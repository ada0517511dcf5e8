// SPDX-License-Identifier: MIT
// Reads the functions of a shader off glslang's syntax tree.
#pragma once

#include "shader.h"

class TIntermNode;

namespace gnomon::compiler {

/// Fills in has_main, defined, undefined.
void find_functions(TIntermNode& root, Shader& shader);

/// Lines of the loops that are not bounded in the sense of build(), in the order of the text.
[[nodiscard]] std::vector<int> find_unbounded_loops(TIntermNode& root);

}  // namespace gnomon::compiler
