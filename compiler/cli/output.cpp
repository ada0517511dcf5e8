// SPDX-License-Identifier: MIT
#include "cli/output.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

#include "gnomon/atomic_file.h"
#include "gnomon/compiler/depfile.h"

namespace gnomon::cli {

Result<Done> print(const std::string& text) {
  return write_file_atomically({}, std::as_bytes(std::span(text)));
}

std::string path_of(const std::string& output) {
  return output == "-" ? std::string() : output;
}

std::optional<Diagnostic> replaced_source(const std::vector<std::string>& sources,
                                          const std::vector<std::string>& outputs) {
  std::error_code ignored;
  for (const std::string& output : outputs) {
    for (const std::string& source : sources) {
      if (std::filesystem::equivalent(source, output, ignored))
        return Diagnostic{.file = output, .message = "is a source of this shader: write to another file"};
    }
  }
  return std::nullopt;
}

std::optional<Diagnostic> shared_output(const Command& command) {
  std::vector<std::filesystem::path> known;
  bool is_stdout_taken = command.output.empty();
  for (const std::string& output : {command.output, command.reflection, command.depfile}) {
    if (output.empty()) continue;
    if (output == "-" && std::exchange(is_stdout_taken, true))
      return Diagnostic{.message =
                            "two outputs are asked for on standard output: name a file for one of -o, "
                            "--reflect and -MF"};
    if (output == "-") continue;
    std::error_code ignored;
    const std::filesystem::path path =
        std::filesystem::weakly_canonical(std::filesystem::absolute(output, ignored), ignored);
    if (std::ranges::find(known, path) != known.end())
      return Diagnostic{.file = output,
                        .message = "is asked for twice, by two of -o, --reflect and -MF: name two files"};
    known.push_back(path);
  }
  return std::nullopt;
}

namespace {

std::optional<Diagnostic> wrong_files(const compiler::Compiled& shader, const Command& command) {
  if (auto replaced =
          replaced_source(shader.source.files, {command.output, command.reflection, command.depfile}))
    return replaced;
  if (command.output.empty() && shader.format == compiler::Format::kSpirv)
    return Diagnostic{.message = "SPIR-V is binary: name a file for it with -o"};
  return std::nullopt;
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

}  // namespace

Result<Done> write(const compiler::Compiled& shader, const Command& command) {
  if (auto wrong = wrong_files(shader, command)) return *std::move(wrong);
  const std::string json = compiler::to_json(shader.reflection);
  const std::string rule = compiler::to_depfile(command.output, shader.source.files);
  std::vector<FileContent> files;
  if (!command.reflection.empty()) files.push_back({path_of(command.reflection), bytes_of(json)});
  if (!command.depfile.empty()) files.push_back({path_of(command.depfile), bytes_of(rule)});
  files.push_back({command.output, bytes_of(shader.output)});
  return write_files_atomically(files);
}

}  // namespace gnomon::cli
