// SPDX-License-Identifier: MIT
#include "technique/program_cache.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "technique/hash.h"

namespace gnomon::technique {
Result<CachedProgram> ProgramCache::make(const std::string& fragment, const std::string& vertex_stage) const {
  const auto path = [&](const std::string& name) {
    return (std::filesystem::path(options_.library_directory) / name).lexically_normal().string();
  };
  for (const std::string& needed : {vertex_stage, fragment}) {
    if (std::error_code error; std::filesystem::exists(path(needed), error)) continue;
    return Diagnostic{.file = path(needed),
                      .message = "missing: the shader library at " + options_.library_directory +
                                 " is incomplete; install gnomon again, or build it from its source tree",
                      .failure = Failure::kMachine};
  }
  const Result<compiler::Compiled> vertex = compiler::build(path(vertex_stage), options_);
  if (!vertex) return vertex.diagnostics();
  const Result<compiler::Compiled> pixel = compiler::build(path(fragment), options_);
  if (!pixel) return pixel.diagnostics();
  Result<gl::Program> program = gl::Program::link(fragment, vertex->output, pixel->output);
  if (!program) return program.diagnostics();
  return CachedProgram{std::move(program).value(), hash_text(pixel->output),
                       hash_text(vertex->output + pixel->output)};
}

Result<const CachedProgram*> ProgramCache::get(const std::string& fragment, const std::string& vertex) {
  const std::pair stages(vertex, fragment);
  if (const auto it = programs_.find(stages); it != programs_.end()) return &it->second;
  Result<CachedProgram> made = make(fragment, vertex);
  if (!made) return made.diagnostics();
  return &programs_.emplace(stages, std::move(made).value()).first->second;
}

}  // namespace gnomon::technique
