// SPDX-License-Identifier: MIT
// How messages are spelt so that editors and build systems find the line.
#pragma once

#include <string>

#include "gnomon/diagnostic.h"

namespace gnomon::cli {

enum class ErrorFormat {
  kGcc,  ///< PATH:LINE: error: TEXT
  kMsvc  ///< PATH(LINE): error: TEXT
};

[[nodiscard]] std::string format(const Diagnostic& diagnostic, ErrorFormat format);

}  // namespace gnomon::cli
