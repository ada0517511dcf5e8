// SPDX-License-Identifier: MIT
// Where a command's result goes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace gnomon::cli {

/// Why nothing may be written: one of `outputs` is one of `sources` (kInvalid). An empty path is no output.
[[nodiscard]] std::optional<Diagnostic> replaced_source(const std::vector<std::string>& sources,
                                                        const std::vector<std::string>& outputs);

/// Writes to standard output. Fails (kMachine) where not all of it arrives.
[[nodiscard]] Result<Done> print(const std::string& text);

/// Where an output of the command goes: "-" is standard output, for which write_file_atomically() wants none.
[[nodiscard]] std::string path_of(const std::string& output);

/// What is wrong with a command that wants two outputs in one file; nothing else.
[[nodiscard]] std::optional<Diagnostic> shared_output(const Command& command);

/// Writes the output of a shader to the command's output, or to standard output where it has none, with its
/// reflection and depfile where the command asks for them: all of these files or none. Fails (kMachine) where
/// that is not possible, (kInvalid) where one is a source of the shader, and for SPIR-V without a file.
[[nodiscard]] Result<Done> write(const compiler::Compiled& shader, const Command& command);

}  // namespace gnomon::cli
