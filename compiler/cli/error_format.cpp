// SPDX-License-Identifier: MIT
#include "cli/error_format.h"

namespace gnomon::cli {

std::string format(const Diagnostic& diagnostic, ErrorFormat format) {
  if (format == ErrorFormat::kGcc || diagnostic.line == 0) return to_string(diagnostic);
  Diagnostic located = diagnostic;
  located.file.append("(").append(std::to_string(diagnostic.line));
  if (diagnostic.column > 0) located.file.append(",").append(std::to_string(diagnostic.column));
  located.file += ")";
  located.line = 0;
  return to_string(located);
}

}  // namespace gnomon::cli
