// SPDX-License-Identifier: MIT
// Pieces of a scene's document that several sections hold. Their shape has been checked by the schema.
#pragma once

#include <array>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "scene/build.h"
#include "scene/json.h"
#include "scene/project.h"
#include "scene/report.h"

namespace gnomon::scene {

[[nodiscard]] int integer_of(const json::Value& value);
[[nodiscard]] std::array<int, 2> integer_pair_of(const json::Value& value);

/// The member `key` of an object, where it is there.
void read_number(const json::Value& object, const char* key, double& number);
void read_integer(const json::Value& object, const char* key, int& number);

/// Reports a name that is not among the known ones.
void check_name(const std::string& noun, const std::string& name, const std::vector<std::string>& known,
                json::Place place, const std::string& pointer, Report& report);

/// The angle in [0, 360) that is as many degrees but for whole turns.
[[nodiscard]] double compass(double degrees);

/// The file of this name, relative to the scene's folder; reports one outside of the root, or none.
[[nodiscard]] InsideFile inside_file(const json::Value& name, const std::string& pointer,
                                     const BuildContext& context, Report& report);

/// A list of numbers as a document's value.
template <class Numbers>
[[nodiscard]] json::Value list_of(const Numbers& numbers) {
  json::Array values;
  for (const auto number : numbers) {
    if constexpr (std::is_integral_v<std::remove_const_t<decltype(number)>>) {
      values.push_back({std::int64_t{number}});
    } else {
      values.push_back({number});
    }
  }
  return {std::move(values)};
}

}  // namespace gnomon::scene
