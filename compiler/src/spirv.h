// SPDX-License-Identifier: MIT
// From SPIR-V to what a target wants of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// What SPIRV-Tools finds wrong with a module by the rules of its target; nothing for a valid one.
[[nodiscard]] std::optional<std::string> defect_of(std::span<const std::uint32_t> spirv, Rules rules);

/// A text in another language by SPIRV-Cross, or the reason why there is none. `push_constants`: the register
/// b or the buffer of the push constant block, if there is one.
struct Translation {
  std::string text;
  std::string failure{};
};
[[nodiscard]] Translation translate(std::span<const std::uint32_t> spirv, Format format, int push_constants);

}  // namespace gnomon::compiler
