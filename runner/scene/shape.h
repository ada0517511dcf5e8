// SPDX-License-Identifier: MIT
// Holds a document against the schema and says in our words what is wrong.
#pragma once

#include <string>

#include "scene/json.h"
#include "scene/report.h"

namespace gnomon::scene {

/// Reports every place below `value` (itself at `pointer`) that does not have the shape of `schema`: wrong
/// types, numbers out of range, unknown and missing keys, alternatives that exclude each other.
void check_shape(const json::Value& schema, const json::Value& value, const std::string& pointer,
                 Report& report);

}  // namespace gnomon::scene
