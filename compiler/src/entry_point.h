// SPDX-License-Identifier: MIT
// A main() for a module, so that it can be checked alone.
#pragma once

#include "gnomon/compiler/compiler.h"
#include "shader.h"

namespace gnomon::compiler {

/// Appends to `module` a main() that calls every function which `shader` defines, and bodies for those it
/// lacks. The arguments come from a uniform and every result reaches an output of the stage. A generated line
/// has the origin of the function it stands for, so that an error in it is reported there.
void append_entry_point(Assembled& module, const Shader& shader, Stage stage);

}  // namespace gnomon::compiler
