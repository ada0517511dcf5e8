// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
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

bool is_header(const std::string& name) {
  const Target* target = find_target(name);
  return target != nullptr && target->format == Format::kHeader;
}

std::optional<Diagnostic> wrong_embedding(const std::vector<std::string>& names) {
  if (names.empty()) return Diagnostic{.message = "a header has to embed at least one target"};
  for (auto name = names.begin(); name != names.end(); ++name) {
    if (is_header(*name)) return Diagnostic{.message = "a header cannot embed the target \"" + *name + "\""};
    if (std::find(names.begin(), name, *name) != name)
      return Diagnostic{.message = "the target \"" + *name + "\" is to be embedded twice: name it once"};
  }
  return std::nullopt;
}

// Each target's, but those that another one gave already.
void add_warnings(const Compiled& from, Assembled& to) {
  for (const Diagnostic& warning : from.source.warnings) {
    const auto same = [&](const Diagnostic& other) { return to_string(other) == to_string(warning); };
    if (std::ranges::none_of(to.warnings, same)) to.warnings.push_back(warning);
  }
}

Result<Compiled> make_header(const Request& request) {
  if (auto wrong = wrong_embedding(request.options.embedded)) return *std::move(wrong);
  std::vector<Compiled> embedded;
  for (const std::string& name : request.options.embedded) {
    Result<Compiled> compiled = compile_for(request, name);
    if (!compiled) return compiled;
    embedded.push_back(std::move(compiled).value());
  }
  Compiled header = embedded.front();
  for (const Compiled& compiled : embedded) add_warnings(compiled, header.source);
  header.format = Format::kHeader;
  const std::string file = std::filesystem::path(request.path).filename().string();
  header.output = header_text(file, request.options.name, embedded);
  return header;
}

Result<Compiled> make(const Request& request) {
  return is_header(request.options.target) ? make_header(request)
                                           : compile_for(request, request.options.target);
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
