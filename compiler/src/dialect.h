// SPDX-License-Identifier: MIT
// What an assembled text has to say otherwise in one GLSL dialect than in another.
#pragma once

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// Takes out of layout qualifiers what the target lacks and gives ESSL its default precisions; see build().
/// Whether a descriptor set other than the first was taken out: numbers may clash then.
[[nodiscard]] bool adapt(Assembled& assembled, Stage stage, const Target& target);

}  // namespace gnomon::compiler
