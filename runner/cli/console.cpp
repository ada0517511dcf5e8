// SPDX-License-Identifier: MIT
#include "cli/console.h"

#include <algorithm>
#include <array>
#include <span>

#include "gnomon/atomic_file.h"

namespace gnomon::cli {

int worse(int a, int b) {
  constexpr std::array kRank{130, 99, 2, 1, 77, 0};
  return *std::min(std::find(kRank.begin(), kRank.end(), a), std::find(kRank.begin(), kRank.end(), b));
}

int report(Console& console, const Diagnostics& diagnostics) {
  int code = 0;
  for (const Diagnostic& diagnostic : diagnostics) {
    console.err << to_string(diagnostic) << "\n";
    if (!diagnostic.warning) code = worse(code, static_cast<int>(diagnostic.failure));
  }
  return code;
}

std::ostream& people(Console& console, const std::string& output) {
  return is_stdout(output) ? console.err : console.out;
}

Result<Done> write_text(Console& console, const std::string& output, const std::string& text) {
  if (!is_stdout(output)) return write_file_atomically(output, std::as_bytes(std::span(text)));
  console.out << text;
  return Done{};
}

}  // namespace gnomon::cli
