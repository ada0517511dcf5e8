// SPDX-License-Identifier: MIT
// Test results as text, to travel from a worker process through a pipe.
#pragma once

#include <string>
#include <string_view>

#include "gnomon/diagnostic.h"
#include "report/report.h"

namespace gnomon::report {

/// One line of JSON, without the line feed. Numbers keep every bit that matters, NaN and infinities included.
/// Bytes that are not UTF-8 arrive as U+FFFD.
[[nodiscard]] std::string to_json(const TestResult& result);

/// The result that `to_json` wrote. Fails (Failure::kMachine: the sender broke off or is another program) for
/// anything else, saying which key is at fault.
[[nodiscard]] Result<TestResult> from_json(std::string_view line);

}  // namespace gnomon::report
