// SPDX-License-Identifier: MIT
#include "cli/spelling.h"

#include <algorithm>
#include <string_view>

namespace gnomon::cli {

std::vector<std::string> with_long_names(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const auto end = std::ranges::find(arguments, "--");
  for (auto argument = arguments.begin(); argument != end; ++argument) {
    if (argument->starts_with("-MF") && argument->size() > 3) argument->insert(3, "=");
    if (*argument == "-MD" || argument->starts_with("-MF")) argument->insert(0, "-");
  }
  return arguments;
}

std::string with_typed_names(std::string text) {
  for (const std::string_view name : {"--MD", "--MF"}) {
    for (size_t at = text.find(name); at != text.npos; at = text.find(name, at)) text.erase(at, 1);
  }
  return text;
}

}  // namespace gnomon::cli
