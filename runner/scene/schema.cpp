// SPDX-License-Identifier: MIT
#include "scene/schema.h"

#include <algorithm>

#include "scene/suggest.h"

namespace gnomon::scene {
namespace {

using json::Value;

const Value& whole_schema() {
  static const Value schema = *json::parse(schema_text(), "scene.schema.json").root;
  return schema;
}

std::string string_of(const Value& node, std::string_view key) {
  const Value* value = node.find(key);
  return value && value->get_if<std::string>() ? value->text() : "";
}

bool has_type(const Value& value, std::string_view type) {
  if (type == "object") return value.get_if<json::Object>();
  if (type == "array") return value.get_if<json::Array>();
  if (type == "string") return value.get_if<std::string>();
  if (type == "boolean") return value.get_if<bool>();
  if (type == "integer") return value.get_if<std::int64_t>();
  return type == "number" && value.is_number();
}

std::string describe_number(const Value& node, const std::string& noun) {
  const Value *least = node.find("minimum"), *most = node.find("maximum"),
              *above = node.find("exclusiveMinimum"), *below = node.find("exclusiveMaximum");
  if (least && most) return noun + " from " + dump(*least) + " to " + dump(*most);
  if (least) return noun + " of at least " + dump(*least);
  if (above && below) return noun + " above " + dump(*above) + " and below " + dump(*below);
  if (above) return noun + " above " + dump(*above);
  return noun;
}

/// One of several types that a value may have, without ranges.
std::string describe_type(const std::string& type) {
  return type == "null" ? type
                        : (type == "integer" || type == "array" || type == "object" ? "an " : "a ") + type;
}

std::string describe_list(const Value& node) {
  const Value *least = node.find("minItems"), *most = node.find("maxItems");
  std::string text = "a list";
  if (least && most && least->number() == most->number()) {
    text += " of exactly " + dump(*least);
  } else if (least && most) {
    text += " of " + dump(*least) + " to " + dump(*most);
  } else if (least) {
    text += " of at least " + dump(*least);
  }
  const Value* items = node.find("items");
  return items && items->get_if<json::Object>() ? text + ", each " + describe(*items) : text;
}

std::string describe_object(const Value& node) {
  const std::vector<std::string> required = required_keys(node), known = property_keys(node);
  std::string text = "an object";
  if (!required.empty()) {
    text += " with " + quoted_list(required);
  } else if (!known.empty()) {
    text += " that may hold " + quoted_list(known);
  }
  const Value *others = node.find("additionalProperties"), *least = node.find("minProperties");
  if (!others || !others->get_if<json::Object>()) return text;
  if (known.empty()) return text + " whose values are each " + describe(*others);
  const bool wants_more = least && least->number() > static_cast<double>(required.size());
  return text + (wants_more ? " and at least one further key, each " : " and further keys, each ") +
         describe(*others);
}

}  // namespace

const Value& scene_schema() {
  return whole_schema();
}

const Value& project_schema() {
  return *whole_schema().find("definitions")->find("project");
}

const Value& resolve(const Value& node) {
  constexpr std::string_view kDefinitions = "#/definitions/";
  const std::string reference = string_of(node, "$ref");
  if (!reference.starts_with(kDefinitions)) return node;
  return *whole_schema().find("definitions")->find(std::string_view(reference).substr(kDefinitions.size()));
}

std::vector<const Value*> alternatives(const Value& node) {
  const Value& target = resolve(node);
  const Value* one_of = target.find("oneOf");
  if (!one_of) return {&target};
  std::vector<const Value*> result;
  for (const Value& alternative : one_of->array()) result.push_back(&resolve(alternative));
  return result;
}

const Value* choose_alternative(const Value& node, const Value& value) {
  const std::vector<const Value*> all = alternatives(node);
  if (!resolve(node).find("oneOf")) return all.front();
  const Value* fallback = nullptr;
  for (const Value* alternative : all) {
    if (!has_type(value, string_of(*alternative, "type"))) continue;
    const std::vector<std::string> required = required_keys(*alternative);
    const bool named =
        std::all_of(required.begin(), required.end(), [&](const auto& key) { return value.find(key); });
    if (!required.empty() && named) return alternative;
    if (required.empty()) fallback = alternative;
  }
  return fallback;
}

const Value* member_schema(const Value& node, std::string_view key) {
  const Value* properties = node.find("properties");
  if (const Value* property = properties ? properties->find(key) : nullptr) return property;
  const Value* others = node.find("additionalProperties");
  return others && others->get_if<json::Object>() ? others : nullptr;
}

std::vector<std::string> required_keys(const Value& node) {
  std::vector<std::string> keys;
  if (const Value* required = node.find("required")) {
    for (const Value& key : required->array()) keys.push_back(key.text());
  }
  return keys;
}

std::vector<std::string> property_keys(const Value& node) {
  std::vector<std::string> keys;
  if (const Value* properties = node.find("properties")) {
    for (const json::Member& member : properties->object()) keys.push_back(member.key);
  }
  return keys;
}

std::string describe(const Value& node) {
  const Value& target = resolve(node);
  if (target.find("oneOf")) {
    std::string text;
    for (const Value* alternative : alternatives(target))
      text += (text.empty() ? "" : ", or ") + describe(*alternative);
    return text;
  }
  if (const Value* choices = target.find("enum")) {
    const std::string list = dump(*choices);
    return choices->array().size() == 1 ? dump(choices->array().front())
                                        : "one of " + list.substr(1, list.size() - 2);
  }
  const std::string type = string_of(target, "type");
  if (const Value* types = target.find("type"); types && types->get_if<json::Array>()) {
    std::string text;
    for (const Value& one : types->array()) text += (text.empty() ? "" : " or ") + describe_type(one.text());
    return text;
  }
  if (type == "integer") return describe_number(target, "an integer");
  if (type == "number") return describe_number(target, "a number");
  if (type == "boolean") return "true or false";
  if (type == "array") return describe_list(target);
  if (type == "object") return describe_object(target);
  return target.find("minLength") ? "a string that is not empty" : "a string";
}

std::string describe_with_unit(const Value& node) {
  const std::string unit = string_of(resolve(node), "unit");
  return describe(node) + (unit.empty() ? "" : " (" + unit + ")");
}

std::string description(const Value& node) {
  return string_of(resolve(node), "description");
}

}  // namespace gnomon::scene
