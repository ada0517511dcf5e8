// SPDX-License-Identifier: MIT
// What a target cannot express of code that glslang takes for it.
#pragma once

#include <optional>

#include "declarations.h"

namespace glslang {
class TIntermediate;
}

namespace gnomon::compiler {

/// The first construct, in the order of the text, that main() reaches and the target's language does not
/// have, or that its translator would get wrong. Of a text that is parsed.
[[nodiscard]] std::optional<Message> find_lack(const glslang::TIntermediate& code, const Target& target,
                                               DeclarationLines& lines);

}  // namespace gnomon::compiler
