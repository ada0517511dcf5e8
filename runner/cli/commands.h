// SPDX-License-Identifier: MIT
// The commands of `gnomon`. Each returns the exit code.
#pragma once

#include "cli/arguments.h"
#include "cli/console.h"
#include "scene/load.h"

namespace gnomon::cli {

int run_command(const RenderArguments& arguments, Console& console);
int run_command(const TestArguments& arguments, Console& console);
int run_command(const DiffArguments& arguments, Console& console);
int run_command(const ValidateArguments& arguments, Console& console);
int run_command(const NewArguments& arguments, Console& console);
int run_command(const BenchArguments& arguments, Console& console);
int run_command(const TraceArguments& arguments, Console& console);
int run_command(const InfoArguments& arguments, Console& console);

/// The worker side of `test`: answers requests from standard input on `console.out` until the input ends.
int serve(const TestArguments& arguments, Console& console);

/// The names that scenes may use: methods, procedural maps, channels.
[[nodiscard]] scene::Vocabulary vocabulary();

}  // namespace gnomon::cli
