// SPDX-License-Identifier: MIT
// The published schema (docs/scene.schema.json, embedded when built): the one truth about the shape of scene
// files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/json.h"

namespace gnomon::scene {

/// The text of docs/scene.schema.json, ready to be written beside a gnomon.json.
[[nodiscard]] std::string_view schema_text();

/// The schema of a scene, and that of a gnomon.json.
[[nodiscard]] const json::Value& scene_schema();
[[nodiscard]] const json::Value& project_schema();

/// What `node` refers to, where it is a $ref into the schema's definitions; else `node` itself.
[[nodiscard]] const json::Value& resolve(const json::Value& node);

/// The alternatives of a oneOf (terrain: procedural, file, heights), or `node` alone.
[[nodiscard]] std::vector<const json::Value*> alternatives(const json::Value& node);

/// The alternative that `value` is meant as: by its type, then by the key that only this one requires. Null
/// where nothing tells.
[[nodiscard]] const json::Value* choose_alternative(const json::Value& node, const json::Value& value);

/// The schema of member `key` of an object of this schema; null where it may not have one. Not through a
/// oneOf.
[[nodiscard]] const json::Value* member_schema(const json::Value& node, std::string_view key);

/// The keys under "required", and those under "properties".
[[nodiscard]] std::vector<std::string> required_keys(const json::Value& node);
[[nodiscard]] std::vector<std::string> property_keys(const json::Value& node);

/// For a person: "a number from -90 to 90", "a list of exactly 2, each an integer of at least 0".
[[nodiscard]] std::string describe(const json::Value& node);

/// `describe` with the unit in brackets, where the node has one.
[[nodiscard]] std::string describe_with_unit(const json::Value& node);

/// The string under "description", or "".
[[nodiscard]] std::string description(const json::Value& node);

}  // namespace gnomon::scene
