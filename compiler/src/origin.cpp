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
    const std::string& includer = file_of(assembled, at.parent);
    // The text of assemble_all() has no name and is nobody's.
    if (!includer.empty()) chain.push_back("included from " + includer + ":" + std::to_string(at.line));
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

std::string portable_name(const std::string& file, const Assembled& assembled, const std::string& library) {
  namespace fs = std::filesystem;
  const auto seen_from = [&](const fs::path& folder) {
    std::error_code ignored;
    return fs::absolute(file, ignored)
        .lexically_normal()
        .lexically_relative(fs::absolute(folder / ".", ignored).lexically_normal());
  };
  const fs::path in_library = library.empty() ? fs::path() : seen_from(library);
  if (!in_library.empty() && *in_library.begin() != "..") return ("gnomon" / in_library).generic_string();
  // A text of several modules has no main file: each is called by its own name.
  const std::string& main_file = assembled.files.front();
  return main_file.empty() ? fs::path(file).filename().generic_string()
                           : seen_from(fs::path(main_file).parent_path()).generic_string();
}

Diagnostic locate(const Assembled& assembled, int line, std::string message) {
  const int last = static_cast<int>(assembled.origins.size());
  const int nearest = std::clamp(line, 1, std::max(last, 1));
  return failure_at(assembled, assembled.origins[static_cast<size_t>(nearest - 1)], std::move(message));
}

}  // namespace gnomon::compiler
