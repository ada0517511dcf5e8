// SPDX-License-Identifier: MIT
#include "cli/output.h"

#include <cstdio>
#include <filesystem>
#include <span>

#include "gnomon/atomic_file.h"

namespace gnomon::cli {

Result<Done> print(const std::string& text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0)
    return Done{};
  return Diagnostic{.message = "cannot write to standard output", .failure = Failure::kMachine};
}

Result<Done> write_beside(const compiler::Compiled& shader, const std::string& text,
                          const std::string& path) {
  std::error_code ignored;
  for (const std::string& source : shader.source.files) {
    if (std::filesystem::equivalent(source, path, ignored)) {
      return Diagnostic{.file = path, .message = "is a source of this shader: write to another file"};
    }
  }
  return write_file_atomically(path, std::as_bytes(std::span(text)));
}

Result<Done> write(const compiler::Compiled& shader, const std::string& path) {
  if (!path.empty()) return write_beside(shader, shader.output, path);
  if (shader.format == compiler::Format::kSpirv)
    return Diagnostic{.message = "SPIR-V is binary: name a file for it with -o"};
  return print(shader.output);
}

}  // namespace gnomon::cli
