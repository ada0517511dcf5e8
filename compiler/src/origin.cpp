// SPDX-License-Identifier: MIT
#include "origin.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace gnomon::compiler {

const std::string& file_of(const Assembled& assembled, int inclusion) {
  const Inclusion& at = assembled.inclusions[static_cast<size_t>(inclusion)];
  return assembled.files[static_cast<size_t>(at.file)];
}

Diagnostic failure_at(const Assembled& assembled, LineOrigin origin, std::string message) {
  Diagnostic diagnostic{.message = std::move(message), .failure = Failure::kFailed};
  if (origin.line == 0) {
    diagnostic.file = "<command line>";
    return diagnostic;
  }
  diagnostic.file = file_of(assembled, origin.inclusion);
  diagnostic.line = origin.line;
  std::vector<std::string> chain;
  for (Inclusion at = assembled.inclusions[static_cast<size_t>(origin.inclusion)]; at.parent >= 0;
       at = assembled.inclusions[static_cast<size_t>(at.parent)]) {
    chain.push_back("included from " + file_of(assembled, at.parent) + ":" + std::to_string(at.line));
  }
  // Both ends of a long chain say enough.
  constexpr size_t shown = 4;
  if (chain.size() > 3 * shown) {
    const auto end = chain.end() - shown;
    const std::string left_out = "... " + std::to_string(chain.size() - 2 * shown) + " more ...";
    chain.insert(chain.erase(chain.begin() + shown, end), left_out);
  }
  diagnostic.notes = std::move(chain);
  return diagnostic;
}

std::string portable_name(const std::string& file, const Assembled& source, const std::string& library) {
  namespace fs = std::filesystem;
  const fs::path in_library = fs::path(file).lexically_relative(fs::path(library).lexically_normal());
  if (!library.empty() && !in_library.empty() && *in_library.begin() != "..")
    return ("gnomon" / in_library).generic_string();
  const fs::path beside = fs::path(file).lexically_relative(fs::path(source.files.front()).parent_path());
  return beside.empty() ? file : beside.generic_string();
}

Diagnostic locate(const Assembled& assembled, int line, std::string message) {
  const int last = static_cast<int>(assembled.origins.size());
  const int nearest = std::clamp(line, 1, std::max(last, 1));
  return failure_at(assembled, assembled.origins[static_cast<size_t>(nearest - 1)], std::move(message));
}

}  // namespace gnomon::compiler
