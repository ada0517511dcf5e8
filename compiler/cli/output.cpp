// SPDX-License-Identifier: MIT
#include "cli/output.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <span>

#include "gnomon/atomic_file.h"
#include "gnomon/compiler/depfile.h"

namespace gnomon::cli {

Result<Done> print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return Done{};
  return Diagnostic{.message = "cannot write to standard output", .failure = Failure::kMachine};
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
  for (const std::string& output : {command.output, command.reflection, command.depfile}) {
    if (output.empty()) continue;
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
  if (!command.reflection.empty()) files.push_back({command.reflection, bytes_of(json)});
  if (!command.depfile.empty()) files.push_back({command.depfile, bytes_of(rule)});
  if (!command.output.empty()) files.push_back({command.output, bytes_of(shader.output)});
  const Result<Done> written = write_files_atomically(files);
  return written && command.output.empty() ? print(shader.output) : written;
}

}  // namespace gnomon::cli
