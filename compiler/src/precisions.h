// SPDX-License-Identifier: MIT
// Default precisions.
#pragma once

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// Gives every type of the target that has a precision `highp` by default. #extension, which no code may
/// precede, is moved to the front, or stays before the statements where a conditional is around it. Lines
/// that are added have no line number of their own; no other error moves.
void add_precisions(Assembled& assembled, const Target& target);

/// Where the user states other precisions (`precision mediump float;`), gives them to the user's text only:
/// the library's, and the user's definitions of its host functions, stay highp, as positions need it. Part of
/// add_precisions.
void keep_library_precise(Assembled& assembled);

}  // namespace gnomon::compiler
