// SPDX-License-Identifier: MIT
#include <algorithm>
#include <filesystem>
#include <utility>

#include "dialect.h"
#include "entry_point.h"
#include "gnomon/compiler/compiler.h"
#include "header.h"
#include "origin.h"
#include "reflect.h"
#include "refusal.h"
#include "shader.h"
#include "spirv.h"
#include "text.h"

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

Diagnostic locate_message(const Assembled& assembled, const Message& message) {
  Diagnostic diagnostic = locate(assembled, message.line, message.text);
  if (message.related == 0) return diagnostic;
  const Diagnostic other = locate(assembled, message.related, {});
  if (other.line > 0)
    diagnostic.notes.insert(diagnostic.notes.begin(),
                            "the other one: " + other.file + ":" + std::to_string(other.line));
  return diagnostic;
}

// What is compiled: the same for every target that is tried.
struct Request {
  const std::string& path;
  const Options& options;
  Stage stage;
  bool module;  // a text without main() is complete all the same
};

// A failure that other targets may not have.
struct Refusal {
  Diagnostic diagnostic;
  bool by_target = false;  // it is certain that the target is why
};

struct Attempt {
  Compiled compiled;
  std::optional<Refusal> refusal;
};

// "layout(local_size_x = 8)": the line that makes a text one of this stage.
int line_of_stage(const Assembled& assembled, Stage stage) {
  const std::string code = blank_comments(assembled.text);
  const std::string_view word = stage == Stage::kCompute ? "local_size" : "max_vertices";
  const size_t at = std::min(code.find(word), code.size());
  if (at == code.size()) return 1;
  return 1 + static_cast<int>(std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

Refusal refuse_stage(const Assembled& assembled, Stage stage, const Target& target) {
  return {locate(assembled, line_of_stage(assembled, stage),
                 stage_name(stage).title + " shaders: the target " + target.name + " has none"),
          true};
}

// Text, SPIR-V or translation.
std::optional<Refusal> make_output(const Shader& shader, const Target& target, Compiled& compiled) {
  if (target.format == Format::kGlsl) {
    compiled.output = compiled.source.text;
    return std::nullopt;
  }
  compiled.reflection.spirv_size = shader.spirv.size() * sizeof(std::uint32_t);
  if (auto defect = defect_of(shader.spirv, target.rules))
    return Refusal{locate(compiled.source, 1, "the SPIR-V made of it is not valid: " + *defect), true};
  if (target.format == Format::kSpirv) {
    compiled.output.assign(reinterpret_cast<const char*>(shader.spirv.data()),
                           *compiled.reflection.spirv_size);
    return std::nullopt;
  }
  Translation translation = translate(shader.spirv, target.format);
  if (!translation.failure.empty()) return Refusal{locate(compiled.source, 1, translation.failure), true};
  compiled.output = std::move(translation.text);
  return std::nullopt;
}

// Compiles and judges for one target. A failure that no target mends is the Result's own.
Result<Attempt> attempt(const Request& request, const Target& target) {
  Options options = request.options;
  options.target = target.name;
  Result<Assembled> assembled = assemble(request.path, options);
  if (!assembled) return assembled.diagnostics();
  Attempt result{{.source = std::move(assembled).value(),
                  .output = {},
                  .format = target.format,
                  .is_module = false,
                  .reflection = {}},
                 std::nullopt};
  Assembled& source = result.compiled.source;
  if (std::ranges::find(target.stages, request.stage) == target.stages.end()) {
    result.refusal = refuse_stage(source, request.stage, target);
    return result;
  }
  adapt(source, request.stage, target);
  Shader shader = compile(source.text, request.stage, target);
  if (!shader.error && !shader.has_main) {
    if (!request.module) {
      return Diagnostic{.file = request.path,
                        .message = "has no main(): it is a module, not a shader; use gnomonc check"};
    }
    result.compiled.is_module = true;
    append_entry_point(source, shader, request.stage);
    Shader complete = compile(source.text, request.stage, target);
    shader.error = complete.error;
    shader.interface = std::move(complete.interface);
    shader.spirv = std::move(complete.spirv);
  }
  if (shader.error) {
    result.refusal = Refusal{locate_message(source, *shader.error)};
    return result;
  }
  add_warnings(shader, source);
  if (auto unbounded = judge_loops(shader, options, source)) return *std::move(unbounded);
  result.compiled.reflection = complete_reflection(shader, source, options.library_directory);
  result.refusal = make_output(shader, target, result.compiled);
  return result;
}

// Whether a target has no objection at the place and of the kind of `refusal`.
bool takes(const Request& request, const Target& target, const Diagnostic& refusal) {
  const Result<Attempt> other = attempt(request, target);
  if (!other || !other->refusal) return true;
  const Diagnostic& objection = other->refusal->diagnostic;
  return objection.line != refusal.line || objection.file != refusal.file;
}

// Says which targets do not refuse it, where there are any.
Diagnostic explain(const Request& request, const Target& target, Refusal refusal) {
  const auto accepts = [&](const Target& other) { return takes(request, other, refusal.diagnostic); };
  // What neither of the two that have most takes is a mistake, not a lack.
  const bool lack =
      refusal.by_target || std::ranges::any_of(std::vector{"glsl450", "vulkan"}, [&](const char* name) {
        return target.name != name && accepts(*find_target(name));
      });
  if (!lack) return refusal.diagnostic;
  const std::vector<std::string> others = targets_that_take(target, accepts);
  if (others.empty()) return refusal.diagnostic;
  Diagnostic explained = std::move(refusal.diagnostic);
  explained.message += "; refused for the target " + target.name + ", taken by " + join(others);
  return explained;
}

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
