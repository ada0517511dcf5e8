// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <utility>

#include "entry_point.h"
#include "gnomon/compiler/compiler.h"
#include "origin.h"
#include "shader.h"

namespace gnomon::compiler {
namespace {

namespace fs = std::filesystem;

bool lies_below(const std::string& path, const std::string& folder) {
  if (folder.empty()) return false;
  std::error_code error;
  const fs::path child = fs::weakly_canonical(path, error);
  const fs::path parent = fs::weakly_canonical(fs::path(folder) / "", error);
  const auto last = parent.filename().empty() ? std::prev(parent.end()) : parent.end();
  return !error && std::mismatch(parent.begin(), last, child.begin(), child.end()).first == last;
}

// The first loop without a bound in the library, else a warning for each of the others.
std::optional<Diagnostic> judge_loops(const Shader& shader, const Options& options, Assembled& assembled) {
  for (const int line : shader.unbounded_loops) {
    Diagnostic diagnostic =
        locate(assembled, line,
               "loop without a bound: write for (int i = 0; i < LIMIT; ++i), with a limit that the "
               "loop does not modify, and say so where it is reached");
    if (lies_below(diagnostic.file, options.library_directory)) return diagnostic;
    diagnostic.warning = true;
    assembled.warnings.push_back(std::move(diagnostic));
  }
  return std::nullopt;
}

void add_warnings(const Shader& shader, Assembled& assembled) {
  for (const Message& warning : shader.warnings) {
    Diagnostic diagnostic = locate(assembled, warning.line, warning.text);
    diagnostic.warning = true;
    assembled.warnings.push_back(std::move(diagnostic));
  }
}

// Compiles and judges. `module` says whether a text without main() is complete all the same.
Result<Assembled> validate(const std::string& path, const Options& options, Stage stage, bool module) {
  Result<Assembled> assembled = assemble(path, options);
  if (!assembled) return assembled;
  Shader shader = compile(assembled->text, stage);
  if (!shader.error && !shader.has_main) {
    if (!module) {
      return Diagnostic{.file = path,
                        .message = "has no main(): it is a module, not a shader; use gnomonc check"};
    }
    append_entry_point(*assembled, shader, stage);
    const Shader complete = compile(assembled->text, stage);
    shader.error = complete.error;
  }
  if (shader.error) return locate(*assembled, shader.error->line, shader.error->text);
  add_warnings(shader, *assembled);
  if (auto unbounded = judge_loops(shader, options, *assembled)) return *std::move(unbounded);
  return assembled;
}

std::optional<Stage> wanted_stage(const std::string& path, const Options& options) {
  return options.stage ? options.stage : stage_of(path);
}

}  // namespace

Result<Assembled> build(const std::string& path, const Options& options) {
  const auto stage = wanted_stage(path, options);
  if (stage) return validate(path, options, *stage, false);
  if (auto assembled = assemble(path, options); !assembled) return assembled;
  return Diagnostic{
      .file = path,
      .message =
          "the extension tells no shader stage: name the file .vert, .frag, .geom or .comp, or give "
          "--stage; for a module, a file without main(), use gnomonc check"};
}

Result<Assembled> check(const std::string& path, const Options& options) {
  return validate(path, options, wanted_stage(path, options).value_or(Stage::kFragment), true);
}

}  // namespace gnomon::compiler
