// SPDX-License-Identifier: MIT
// One shader for one target, from its file to the target's output.
#pragma once

#include <optional>
#include <string>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {

/// What is compiled: the same for every target that is tried.
struct Request {
  const std::string& path;
  const Options& options;  ///< but for its target
  Stage stage;
  bool module;  ///< a text without main() is complete all the same
};

/// A failure that other targets may not have.
struct Refusal {
  enum class Of {
    kText,    ///< by glslang, at a place of the text
    kStage,   ///< the target has no such stage
    kOutput,  ///< the text is valid, but the target cannot express it
  };
  Diagnostic diagnostic;
  Of of = Of::kText;
  std::string lacking{};  ///< of kText: what to say where it is the target that lacks something; may be empty
  int place = 0;          ///< of kText: lines of the sources before it, the same for every target
};

struct Attempt {
  Compiled compiled;
  std::optional<Refusal> refusal;
};

/// Compiles and judges. A failure that no target mends (of assembly, of loops) is the Result's own.
[[nodiscard]] Result<Attempt> attempt(const Request& request, const Target& target);

}  // namespace gnomon::compiler
