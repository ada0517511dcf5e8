// SPDX-License-Identifier: MIT
#include "scene/edit.h"

#include <algorithm>
#include <charconv>

#include "scene/schema.h"

namespace gnomon::scene {
namespace {

using json::Object;
using json::Value;

std::optional<std::size_t> index_in(const json::Array& array, const std::string& part) {
  std::size_t index = 0;
  const char* end = part.data() + part.size();
  const auto [stop, error] = std::from_chars(part.data(), end, index);
  if (error != std::errc{} || stop != end || index >= array.size()) return std::nullopt;
  return index;
}

/// The alternative of `node` that will hold `key`. Where the key decides for another alternative than the
/// present one, the members that belong to the present one are removed.
const Value* alternative_for(const Value& node, Value& object, const std::string& key) {
  const Value* present = choose_alternative(node, object);
  if (present && member_schema(*present, key)) return present;
  for (const Value* alternative : alternatives(node)) {
    const std::vector<std::string> required = required_keys(*alternative);
    const bool decides =
        required.empty() || std::find(required.begin(), required.end(), key) != required.end();
    if (!decides || !member_schema(*alternative, key)) continue;
    std::erase_if(*object.get_if<Object>(),
                  [&](const json::Member& m) { return !member_schema(*alternative, m.key); });
    return alternative;
  }
  return present;
}

/// The schema below `node` at `key` of `object`; null where the schema has nothing to say.
const Value* descend(const Value* node, Value& object, const std::string& key) {
  const Value* alternative = node ? alternative_for(*node, object, key) : nullptr;
  return alternative ? member_schema(*alternative, key) : nullptr;
}

}  // namespace

Result<Override> parse_override(const std::string& argument, int source) {
  const std::size_t equals = argument.find('=');
  const std::string key = argument.substr(0, equals);
  const std::string name = "--set " + key;
  if (equals == std::string::npos)
    return Diagnostic{name, 0, 0, "expected KEY=VALUE, such as sun.elevation=5"};
  if (std::optional<std::string> problem = key_problem(key)) return Diagnostic{name, 0, 0, *problem};
  const std::string text = argument.substr(equals + 1);
  json::Parsed parsed = json::parse(text, name, source);
  Value value = parsed.root && parsed.diagnostics.empty() ? *std::move(parsed.root) : Value{text};
  const auto relocate = [source](const auto& self,
                                 Value& part) -> void {  // positions inside an argument help nobody
    part.place = {source};
    if (json::Array* items = part.get_if<json::Array>()) {
      for (Value& item : *items) self(self, item);
    } else if (Object* members = part.get_if<Object>()) {
      for (json::Member& member : *members) {
        member.place = {source};
        self(self, member.value);
      }
    }
  };
  relocate(relocate, value);
  return Override{key, std::move(value)};
}

std::optional<std::string> key_problem(std::string_view key) {
  const std::vector<std::string> parts = split_key(key);
  if (std::any_of(parts.begin(), parts.end(), [](const std::string& part) { return part.empty(); })) {
    return "expected a dotted key such as sun.elevation, got \"" + std::string(key) + "\"";
  }
  if (parts.size() > 16) return "a key of more than 16 parts leads nowhere in a scene";
  for (const char* fixed : {"$schema", "version", "matrix"}) {
    if (parts.front() == fixed) return "\"" + parts.front() + "\" is the same for all tests of a scene file";
  }
  return std::nullopt;
}

std::optional<std::string> set_value(Value& root, std::string_view key, const Value& value) {
  const std::vector<std::string> parts = split_key(key);
  Value* at = &root;
  const Value* node = &scene_schema();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool last = i + 1 == parts.size();
    if (json::Array* items = at->get_if<json::Array>()) {
      const std::optional<std::size_t> index = index_in(*items, parts[i]);
      if (!index)
        return "\"" + parts[i] + "\" is none of this list's " + std::to_string(items->size()) +
               " entries (from 0)";
      const Value* each = node ? resolve(*node).find("items") : nullptr;
      node = each && each->get_if<Object>() ? each : nullptr;
      at = &(*items)[*index];
      if (last) *at = value;
      continue;
    }
    if (!at->get_if<Object>())
      return "\"" + parts[i] + "\" would lie inside " + excerpt(*at) + ", which is no object";
    node = descend(node, *at, parts[i]);
    Value* member = at->find(parts[i]);
    at = last || !member ? &at->set(parts[i], last ? value : Value{Object{}, value.place}, value.place)
                         : member;
  }
  return std::nullopt;
}

const Value* find_value(const Value& root, std::string_view key) {
  const Value* at = &root;
  for (const std::string& part : split_key(key)) {
    if (const json::Array* items = at->get_if<json::Array>()) {
      const std::optional<std::size_t> index = index_in(*items, part);
      at = index ? &(*items)[*index] : nullptr;
    } else {
      at = at->find(part);
    }
    if (!at) return nullptr;
  }
  return at;
}

std::string pointer_to(std::string_view key) {
  std::string pointer;
  for (const std::string& part : split_key(key)) pointer = json::child(pointer, part);
  return pointer;
}

std::vector<std::string> split_key(std::string_view key) {
  std::vector<std::string> parts(1);
  for (const char c : key) {
    if (c == '.') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

}  // namespace gnomon::scene
