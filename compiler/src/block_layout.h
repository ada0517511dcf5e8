// SPDX-License-Identifier: MIT
// Where the members of a block lie.
#pragma once

#include <vector>

#include "gnomon/compiler/reflection.h"

namespace glslang {
class TType;
}

namespace gnomon::compiler {

/// Fills in the members and the size of a block of this type, by the rules with which glslang writes SPIR-V.
/// Without `with_bytes` the names and types only.
void read_members(const glslang::TType& type, bool with_bytes, Block& block);

}  // namespace gnomon::compiler
