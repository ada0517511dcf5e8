// SPDX-License-Identifier: MIT
#include "cli/console.h"

#include <algorithm>
#include <array>

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

}  // namespace gnomon::cli
