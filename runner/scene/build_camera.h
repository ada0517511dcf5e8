// SPDX-License-Identifier: MIT
// The "camera" of a scene: from its document, and back in canonical form.
#pragma once

#include "scene/build.h"
#include "scene/json.h"
#include "scene/report.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// `value` has the shape that the schema asks for, or is null (the default: one pixel for each sample).
[[nodiscard]] Camera read_camera(const json::Value* value, const BuildContext& context, Report& report);

/// With every default filled in; a file is named by its path below the root.
[[nodiscard]] json::Value canonical_camera(const Camera& camera);

/// Width and height of the image in pixels; absent for points, whose file tells.
[[nodiscard]] std::optional<std::array<int, 2>> image_size(const Camera& camera, std::array<int, 2> map_size);

}  // namespace gnomon::scene
