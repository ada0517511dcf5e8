// SPDX-License-Identifier: MIT
#include <utility>

#include "attempt.h"
#include "gnomon/compiler/compiler.h"
#include "header.h"
#include "refusal.h"

namespace gnomon::compiler {
namespace {

Result<Compiled> compile_for(const Request& request, const std::string& name) {
  const Target* target = find_target(name);
  if (target == nullptr) return unknown_target(name);
  Result<Attempt> made = attempt(request, *target);
  if (!made) return made.diagnostics();
  if (made->refusal) return explain(request, *target, *std::move(made->refusal));
  return std::move(made->compiled);
}

Result<Compiled> make_header(const Request& request) {
  std::vector<Compiled> embedded;
  for (const std::string& name : request.options.embedded) {
    if (const Target* target = find_target(name); target != nullptr && target->format == Format::kHeader)
      return Diagnostic{.message = "a header cannot embed the target \"" + name + "\""};
    Result<Compiled> compiled = compile_for(request, name);
    if (!compiled) return compiled;
    embedded.push_back(std::move(compiled).value());
  }
  if (embedded.empty()) return Diagnostic{.message = "a header has to embed at least one target"};
  Compiled header = embedded.front();
  header.format = Format::kHeader;
  header.output = header_text(request.path, embedded);
  return header;
}

Result<Compiled> make(const Request& request) {
  const Target* target = find_target(request.options.target);
  const bool is_header = target != nullptr && target->format == Format::kHeader;
  return is_header ? make_header(request) : compile_for(request, request.options.target);
}

std::optional<Stage> wanted_stage(const std::string& path, const Options& options) {
  return options.stage ? options.stage : stage_of(path);
}

}  // namespace

Result<Compiled> build(const std::string& path, const Options& options) {
  const auto stage = wanted_stage(path, options);
  if (stage) return make({path, options, *stage, false});
  if (auto assembled = assemble(path, options); !assembled) return assembled.diagnostics();
  return Diagnostic{
      .file = path,
      .message =
          "the extension tells no shader stage: name the file .vert, .frag, .geom or .comp, or give "
          "--stage; for a module, a file without main(), use gnomonc check"};
}

Result<Compiled> check(const std::string& path, const Options& options) {
  return make({path, options, wanted_stage(path, options).value_or(Stage::kFragment), true});
}

}  // namespace gnomon::compiler
