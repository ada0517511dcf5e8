// SPDX-License-Identifier: MIT
// JSON Schema (draft 7) by valijson; texts in and out, because its headers are slow to compile.
#pragma once

#include <string>
#include <vector>

namespace gnomon::scene {

/// One value that breaks its schema itself (not only through a value inside it).
struct ShapeFailure {
  std::vector<std::string> path;  ///< keys and indices from the root of the value
  std::string words;              ///< valijson's own
};

/// Everything in `value` that breaks `schema`; both are valid JSON texts.
[[nodiscard]] std::vector<ShapeFailure> validate(const std::string& schema, const std::string& value);

}  // namespace gnomon::scene
