// SPDX-License-Identifier: MIT
// The "ground" of a scene: from its document, and back in canonical form.
#pragma once

#include "scene/build.h"
#include "scene/json.h"
#include "scene/report.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// `value` has the shape that the schema asks for, or is null.
[[nodiscard]] Ground read_ground(const json::Value* value, const BuildContext& context, Report& report);

/// With every default filled in; a file is named by its path below the root.
[[nodiscard]] json::Value canonical_ground(const Ground& ground);

}  // namespace gnomon::scene
