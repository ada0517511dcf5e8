// SPDX-License-Identifier: MIT
#include "attempt.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "bindings.h"
#include "declarations.h"
#include "dialect.h"
#include "entry_point.h"
#include "origin.h"
#include "reflect.h"
#include "shader.h"
#include "spirv.h"
#include "target_words.h"
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

// "layout(local_size_x = 8)": the line that makes a text one of this stage.
int line_of_stage(const Assembled& assembled, Stage stage) {
  return line_of_word(assembled.text, stage == Stage::kCompute ? "local_size_x" : "max_vertices");
}

Refusal refuse_stage(const Assembled& assembled, Stage stage, const Target& target) {
  return {locate(assembled, line_of_stage(assembled, stage),
                 stage_name(stage).title + " shaders: the target " + target.name + " has none"),
          Refusal::Of::kStage};
}

std::string_view line_at(std::string_view text, int number) {
  for (int i = 1; i < number && !text.empty(); ++i)
    text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  return text.substr(0, text.find('\n'));
}

Refusal refuse_text(const Assembled& assembled, const Message& error, const Target& target) {
  const auto last = std::min(assembled.origins.size(), static_cast<size_t>(std::max(error.line, 0)));
  const auto end = assembled.origins.begin() + static_cast<std::ptrdiff_t>(last);
  // Lines that stand for options or were added for the target have no number of their own.
  const auto added = std::count(assembled.origins.begin(), end, LineOrigin{0, 0});
  const std::string code = blank_comments(assembled.text);
  return {.diagnostic = locate_message(assembled, error),
          .of = Refusal::Of::kText,
          .lacking = lacking_word(line_at(code, error.line), target).value_or(""),
          .place = static_cast<int>(last) - static_cast<int>(added)};
}

// Two resources at one place, where the source told them apart by sets or left their numbers open.
std::optional<Refusal> refuse_shared_binding(const Assembled& source, const Shader& shader, Stage stage,
                                             const Target& target, bool dropped_sets) {
  const bool is_plain_gl =
      target.rules == Rules::kOpenGl && !dropped_sets;  // there sharing is the author's wish
  if (is_plain_gl) return std::nullopt;
  const auto shared = find_shared_binding(shader.resources, target);
  if (!shared) return std::nullopt;
  const int line = DeclarationLines(source.text, stage, target).of(shared->name);
  return Refusal{locate(source, line, shared->message), Refusal::Of::kOutput};
}

// What a message of SPIRV-Cross, SPIRV-Tools or glslang puts between two marks, all of them.
std::vector<std::string> names_between(std::string_view message, std::string_view open,
                                       std::string_view close) {
  std::vector<std::string> names;
  for (size_t at = message.find(open); at != message.npos;) {
    const size_t begin = at + open.size();
    const size_t end = message.find(close, begin);
    if (end == message.npos) break;
    const std::string_view name = message.substr(begin, end - begin);
    if (is_identifier(name)) names.emplace_back(name);
    at = message.find(open, end + close.size());
  }
  return names;
}

// "(name: block) ... (name: member)", "<id> '7[%x]'", "'x' : ...".
std::vector<std::string> names_in(std::string_view message) {
  for (const auto& [open, close] : {std::pair{"(name: ", ")"}, {"[%", "]"}, {"'", "'"}}) {
    if (auto names = names_between(message, open, close); !names.empty()) return names;
  }
  return {};
}

// By a program behind glslang, which knows no lines.
Refusal refuse_translation(const Compiled& compiled, const Target& target, std::string message) {
  const Assembled& source = compiled.source;
  const std::vector<std::string> names = names_in(message);
  const bool is_packing = message.find("cannot be expressed with") != message.npos && names.size() == 2;
  if (is_packing)
    message = fmt::format(
        "'{}', a member of the block '{}': {} cannot put it where the layout of the source "
        "does: make its members vec4s, and arrays of vec4s",
        names[1], names[0], target.description);
  int line =
      names.empty() ? 0 : DeclarationLines(source.text, compiled.reflection.stage, target).of(names.back());
  Diagnostic diagnostic = locate(source, line, message);
  if (line == 0) diagnostic.line = 0;  // better no line than a wrong one
  return {std::move(diagnostic), Refusal::Of::kOutput};
}

// Text, SPIR-V or translation.
std::optional<Refusal> make_output(const Shader& shader, const Target& target, Compiled& compiled) {
  if (target.format == Format::kGlsl) {
    compiled.output = compiled.source.text;
    return std::nullopt;
  }
  compiled.reflection.spirv_size = shader.spirv.size() * sizeof(std::uint32_t);
  if (auto defect = defect_of(shader.spirv, target.rules))
    return refuse_translation(compiled, target, "the SPIR-V made of it is not valid: " + *defect);
  if (target.format == Format::kSpirv) {
    compiled.output.assign(reinterpret_cast<const char*>(shader.spirv.data()),
                           *compiled.reflection.spirv_size);
    return std::nullopt;
  }
  const auto& blocks = compiled.reflection.blocks;
  const auto push = std::ranges::find(blocks, BlockKind::kPushConstant, &Block::kind);
  const int push_constants = push == blocks.end() ? 0 : push->binding.value_or(0);
  Translation translation = translate(shader.spirv, target.format, push_constants);
  if (!translation.failure.empty())
    return refuse_translation(compiled, target,
                              "cannot be translated for this target: " + translation.failure);
  if (target.format == Format::kHlsl) {
    if (auto defect = defect_of_hlsl(translation.text, compiled.reflection.stage))
      return refuse_translation(compiled, target, "the HLSL made of it is not valid: " + *defect);
  }
  compiled.output = std::move(translation.text);
  return std::nullopt;
}

}  // namespace

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
  const bool dropped_sets = adapt(source, request.stage, target);
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
    shader.objection = std::move(complete.objection);
    shader.resources = std::move(complete.resources);
    shader.reached = std::move(complete.reached);
    shader.interface = std::move(complete.interface);
    shader.spirv = std::move(complete.spirv);
  }
  if (shader.error) {
    result.refusal = refuse_text(source, *shader.error, target);
    return result;
  }
  add_warnings(shader, source);
  if (auto unbounded = judge_loops(shader, options, source)) return *std::move(unbounded);
  result.compiled.reflection =
      complete_reflection(shader, source, request.stage, target, options.library_directory);
  if (shader.objection) result.refusal = {locate_message(source, *shader.objection), Refusal::Of::kOutput};
  if (!result.refusal)
    result.refusal = refuse_shared_binding(source, shader, request.stage, target, dropped_sets);
  if (!result.refusal) result.refusal = make_output(shader, target, result.compiled);
  return result;
}

}  // namespace gnomon::compiler
