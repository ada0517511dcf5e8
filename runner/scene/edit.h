// SPDX-License-Identifier: MIT
// Dotted keys ("sun.elevation", "expect.0.max_steps") into a scene's document: --set and matrix share them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scene/json.h"

namespace gnomon::scene {

/// One --set KEY=VALUE. The value's places carry `source`.
struct Override {
  std::string key;
  json::Value value;
};

/// Reads KEY=VALUE: the value as JSON, else as a string. Fails (located as "--set KEY") without "=" or for an
/// empty or impossible key.
[[nodiscard]] Result<Override> parse_override(const std::string& argument, int source);

/// Why `key` cannot be set at all (an empty part; one that tests may not differ in), or nothing.
[[nodiscard]] std::optional<std::string> key_problem(std::string_view key);

/// Sets the value at the dotted key, creating objects on the way; a value that names one alternative
/// (sun.direction) removes the keys of the others. Returns why it is impossible, else nothing.
[[nodiscard]] std::optional<std::string> set_value(json::Value& root, std::string_view key,
                                                   const json::Value& value);

/// The value at the dotted key; null where there is none.
[[nodiscard]] const json::Value* find_value(const json::Value& root, std::string_view key);

/// "/sun/elevation" for "sun.elevation".
[[nodiscard]] std::string pointer_to(std::string_view key);

[[nodiscard]] std::vector<std::string> split_key(std::string_view key);

}  // namespace gnomon::scene
