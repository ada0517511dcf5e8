// SPDX-License-Identifier: MIT
// What lies between two values of a property that frames move.
#pragma once

#include <optional>
#include <string>

#include "scene/json.h"

namespace gnomon::scene {

/// `step` of the `steps` equal parts of a way; 0 <= step <= steps.
struct Part {
  int step = 0;
  int steps = 1;
};

/// Whether both are numbers, or lists of them of one length: what a scene itself says may have any shape.
[[nodiscard]] bool alike(const json::Value& a, const json::Value& b);

/// The value of a property ("azimuth", "time", "eye", ...) on the way from one value to another, with the
/// place of `to`. An azimuth takes the shorter arc, clockwise where both are half a circle; a direction the
/// great circle at constant speed; a time goes by evenly, to the nanosecond; numbers and lists of numbers go
/// on a straight line. Nothing where no way leads: values of different shapes, no times, opposite directions.
[[nodiscard]] std::optional<json::Value> between(const std::string& property, const json::Value& from,
                                                 const json::Value& to, Part part);

/// Whether two values of "direction" point opposite ways, to 1e-9 rad: every great circle through one goes
/// through the other.
[[nodiscard]] bool opposite(const json::Value& from, const json::Value& to);

}  // namespace gnomon::scene
