// SPDX-License-Identifier: MIT
// Arguments as words again: for workers and for commands that reproduce.
#include "cli/arguments.h"
#include "cli/choices.h"

namespace gnomon::cli {

std::vector<std::string> rendering_flags(const TestArguments& a) {
  const TestArguments defaults;
  std::vector<std::string> words;
  if (a.backend != defaults.backend) words.insert(words.end(), {"--backend", key_of(kBackends, a.backend)});
  if (!a.device.empty()) words.insert(words.end(), {"--device", a.device});
  if (a.target != defaults.target) words.insert(words.end(), {"--target", a.target});
  for (const std::string& override_text : a.overrides) words.insert(words.end(), {"--set", override_text});
  return words;
}

std::vector<std::string> worker_arguments(const TestArguments& a) {
  std::vector<std::string> words{"worker", "--update-goldens", key_of(kUpdates, a.update)};
  if (!a.report.empty()) words.insert(words.end(), {"--report", a.report});
  const std::vector<std::string> flags = rendering_flags(a);
  words.insert(words.end(), flags.begin(), flags.end());
  return words;
}

}  // namespace gnomon::cli
