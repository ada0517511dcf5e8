// SPDX-License-Identifier: MIT
// Options whose text is one of a few words: from the word to the value, and back.
#pragma once

#include <algorithm>
#include <map>
#include <string>

#include "engine.h"
#include "run.h"

namespace gnomon::cli {

inline const std::map<std::string, Backend> kBackends{
    {"auto", Backend::kAuto}, {"egl", Backend::kEgl}, {"osmesa", Backend::kOsmesa}, {"cpu", Backend::kCpu}};
/// Those that draw.
inline const std::map<std::string, Backend> kGlBackends{
    {"auto", Backend::kAuto}, {"egl", Backend::kEgl}, {"osmesa", Backend::kOsmesa}};
inline const std::map<std::string, UpdateGoldens> kUpdates{{"none", UpdateGoldens::kNone},
                                                           {"missing", UpdateGoldens::kMissing},
                                                           {"changed", UpdateGoldens::kChanged},
                                                           {"all", UpdateGoldens::kAll}};

/// Every word, for messages.
template <class Value>
[[nodiscard]] std::string keys_of(const std::map<std::string, Value>& table) {
  std::string keys;
  for (const auto& [key, value] : table) keys += (keys.empty() ? "" : ", ") + key;
  return keys;
}

/// The word of a value, which has one.
template <class Value>
[[nodiscard]] std::string key_of(const std::map<std::string, Value>& table, Value value) {
  return std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.second == value; })
      ->first;
}

}  // namespace gnomon::cli
