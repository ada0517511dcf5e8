// SPDX-License-Identifier: MIT
// The shader compiler as a library: assembles includes, validates with glslang, reports at the original file and line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"

namespace gnomon::compiler {

enum class Stage { kVertex, kFragment, kGeometry, kCompute };

/// The dialects and formats that `build` writes. A new target is one row of the table in src/target.cpp.
struct Target {
  std::string name;          ///< "glsl450"
  std::string version_line;  ///< "#version 450 core"
  std::string description;   ///< one sentence, for --help
};
[[nodiscard]] const std::vector<Target>& targets();

struct Define {
  std::string name;
  std::string value;  ///< "1" where the user gave none
};

struct Options {
  std::string library_directory;         ///< the folder that <gnomon/...> names; its `core/`, `relief/` ...
  std::vector<std::string> include_directories;  ///< -I, in order
  std::vector<Define> defines;           ///< -D, in order
  std::string target = "glsl450";
  std::optional<Stage> stage;            ///< absent: from the file's extension
};

/// Where a line of the assembled text comes from.
struct LineOrigin {
  int file = 0;  ///< index into Assembled::files
  int line = 0;  ///< 1-based
};

/// One self-contained source text. `origins[n]` belongs to line n + 1 of `text`.
struct Assembled {
  std::string text;
  std::vector<std::string> files;  ///< every file read, the main one first; what a depfile names
  std::vector<LineOrigin> origins;
};

/// The stage by extension (.vert .frag .geom .comp), none for other files.
[[nodiscard]] std::optional<Stage> stage_of(const std::string& path);

/// Inlines includes, replaces #version by the target's, puts the defines after it. Fails (Failure::kInvalid) where
/// `path` itself cannot be read, (Failure::kFailed) for a missing include, a cycle, an unterminated conditional.
[[nodiscard]] Result<Assembled> assemble(const std::string& path, const Options& options);

/// assemble + validation by glslang for the target. Fails (kFailed) with one clean first error at its original file and
/// line, the include chain in the notes. A file without main() is kInvalid ("use gnomonc check").
[[nodiscard]] Result<Assembled> build(const std::string& path, const Options& options);

}  // namespace gnomon::compiler
