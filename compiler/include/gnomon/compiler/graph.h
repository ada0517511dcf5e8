// SPDX-License-Identifier: MIT
// The include graph of a shader as text.
#pragma once

#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// One line for each include, in the order of the text: the path of the file, below and two blanks deeper
/// than the one that includes it. What a file includes follows its first line only. Every file of the shader
/// has a line, and without its leading blanks a line is the file's path and nothing else.
[[nodiscard]] std::string to_tree(const Assembled& assembled);

/// A Graphviz digraph: a node for each file, an edge from each file to each that it includes.
[[nodiscard]] std::string to_dot(const Assembled& assembled);

}  // namespace gnomon::compiler
