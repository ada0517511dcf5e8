// SPDX-License-Identifier: MIT
// The "shadow" of a scene: from its document, and back in canonical form.
#pragma once

#include "scene/build.h"
#include "scene/json.h"
#include "scene/report.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// `value` has the shape that the schema asks for, or is null.
[[nodiscard]] Shadow read_shadow(const json::Value* value, const Vocabulary& vocabulary, Report& report);

/// With every default filled in that the method takes.
[[nodiscard]] json::Value canonical_shadow(const Shadow& shadow);

}  // namespace gnomon::scene
