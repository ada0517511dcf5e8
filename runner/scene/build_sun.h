// SPDX-License-Identifier: MIT
// The "sun" of a scene: from its document, and back in canonical form.
#pragma once

#include <array>
#include <optional>

#include "gnomon/diagnostic.h"
#include "scene/json.h"
#include "scene/load.h"
#include "scene/report.h"
#include "scene/sun_at_time.h"

namespace gnomon::scene {

/// `value` has the shape that the schema asks for, or is null. `centre`: of the scene's map, if known. The
/// note is empty where nothing has to be said.
[[nodiscard]] SunOnMap read_sun(const json::Value* value, const std::optional<MapCentre>& centre,
                                Report& report);

/// The vector under "direction", scaled so that its largest component is 1 or -1. Fails, without a file's
/// name, where it has no length. `direction` is a list of three numbers.
[[nodiscard]] Result<std::array<double, 3>> direction_of(const json::Value& direction);

/// With every default filled in. A time stays a time, so that it reads as it was asked, and a later library's
/// last digits do not change what a scene is; the place of a map follows from its file.
[[nodiscard]] json::Value canonical_sun(const Sun& sun);

}  // namespace gnomon::scene
