// SPDX-License-Identifier: MIT
#include "refusal.h"

namespace gnomon::compiler {

std::string join(const std::vector<std::string>& names) {
  if (names.empty()) return "no target";
  std::string text = names.front();
  for (size_t i = 1; i < names.size(); ++i) text += (i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

Diagnostic unknown_target(const std::string& name) {
  std::vector<std::string> known;
  for (const Target& target : targets()) known.push_back(target.name);
  return {.message = "unknown target \"" + name + "\": known are " + join(known)};
}

std::vector<std::string> targets_that_take(const Target& refusing,
                                           const std::function<bool(const Target&)>& takes) {
  std::vector<std::string> names;
  for (const Target& target : targets()) {
    if (target.name == refusing.name || target.format == Format::kHeader) continue;
    if (takes(target)) names.push_back(target.name);
  }
  return names;
}

}  // namespace gnomon::compiler
