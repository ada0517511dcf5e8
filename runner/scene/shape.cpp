// SPDX-License-Identifier: MIT
#include "scene/shape.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/validate.h"

namespace gnomon::scene {
namespace {

using json::child;
using json::Member;
using json::Object;
using json::Value;

/// Whether some $ref or oneOf must be settled before a plain validator's answer can be explained.
bool needs_settling(const Value& node) {
  if (const json::Array* items = node.get_if<json::Array>()) {
    return std::any_of(items->begin(), items->end(), needs_settling);
  }
  const Object* members = node.get_if<Object>();
  return members && std::any_of(members->begin(), members->end(), [](const Member& member) {
           return member.key == "oneOf" || member.key == "$ref" || needs_settling(member.value);
         });
}

const Object& members_of(const Value& value) {
  static const Object none;
  const Object* members = value.get_if<Object>();
  return members ? *members : none;
}

/// Settles each oneOf by the value at hand, and reports where that fails. What remains is a schema without
/// alternatives, in which every failure has one place and one reason.
class Settler {
 public:
  explicit Settler(Report& report) : report_(report) {}

  Value settle(const Value& node, const Value& value, const std::string& pointer) {
    const Value& target = resolve(node);
    if (!needs_settling(target)) return target;
    const Value* chosen = choose_alternative(target, value);
    if (!chosen) {
      report_undecided(target, value, pointer);
      return {Object{}};
    }
    Value settled = *chosen;
    for (const char* key : {"unit", "description"}) {  // what a node says of all its alternatives
      if (const Value* text = target.find(key); text && !settled.find(key)) settled.set(key, *text);
    }
    if (chosen != &target) report_mixed(target, *chosen, value, pointer, settled);
    name_members(members_of(value), settled);
    settle_members(members_of(value), pointer, settled);
    // Something else than a list breaks the type; without items there is nothing left to settle.
    const json::Array* items = value.get_if<json::Array>();
    settle_items(items ? *items : json::Array{}, pointer, settled);
    return settled;
  }

 private:
  /// Members of any name whose schema has to be settled become properties of their own, each to be settled by
  /// its value.
  static void name_members(const Object& members, Value& settled) {
    const Value* others = settled.find("additionalProperties");
    if (!others || !needs_settling(*others)) return;
    const Value schema = *others;
    if (!settled.find("properties")) settled.set("properties", {Object{}});
    for (const Member& member : members) {
      Value* properties = settled.find("properties");
      if (!properties->find(member.key)) properties->set(member.key, schema);
    }
    settled.set("additionalProperties", {true});
  }

  void settle_members(const Object& members, const std::string& pointer, Value& settled) {
    Value* properties = settled.find("properties");
    if (!properties) return;
    for (const Member& member : members) {
      Value* property = properties->find(member.key);
      if (property) *property = settle(Value(*property), member.value, child(pointer, member.key));
    }
    for (Member& property : *properties->get_if<Object>()) {
      if (!needs_settling(property.value)) continue;  // else absent from the value: nothing to settle by
      property.value = {Object{{"description", {}, {description(property.value)}}}};
    }
  }

  void settle_items(const json::Array& items, const std::string& pointer, Value& settled) {
    const Value* schema = settled.find("items");
    if (!schema || !needs_settling(*schema)) return;
    json::Array each;
    for (std::size_t i = 0; i < items.size(); ++i)
      each.push_back(settle(*schema, items[i], child(pointer, i)));
    settled.set("items", {std::move(each)});
  }

  /// Nothing in `value` says which alternative is meant.
  void report_undecided(const Value& node, const Value& value, const std::string& pointer) {
    std::vector<std::string> known;
    for (const Value* alternative : alternatives(node)) {
      for (std::string& key : property_keys(*alternative)) known.push_back(std::move(key));
    }
    bool unknown_key = false;
    for (const Member& member : members_of(value)) {
      if (std::find(known.begin(), known.end(), member.key) != known.end()) continue;
      unknown_key = true;
      report_.error(member.place, child(pointer, member.key), unknown_name("key", member.key, known));
    }
    if (unknown_key) return;
    report_.error(
        value.place, pointer,
        "expected " + describe_with_unit(node) + ", got " + excerpt(value) + ". " + description(node));
  }

  /// Why `key` of the alternative `other` cannot stand in the chosen one. One that requires no key is chosen
  /// where nothing else is: then what is missing is a key of the other.
  static std::string mixed(const std::string& key, const Value& chosen, const Value& other) {
    const std::vector<std::string> required = required_keys(chosen);
    if (required.empty()) return "\"" + key + "\" needs " + quoted_list(required_keys(other)) + " beside it";
    return "\"" + key + "\" does not go together with " + quoted_list(required) + ": give one or the other";
  }

  /// Keys that belong to another alternative than the chosen one. They are accepted in `settled`, being
  /// reported here.
  void report_mixed(const Value& node, const Value& chosen, const Value& value, const std::string& pointer,
                    Value& settled) {
    for (const Member& member : members_of(value)) {
      if (member_schema(chosen, member.key)) continue;
      const std::vector<const Value*> all = alternatives(node);
      const auto other = std::find_if(all.begin(), all.end(), [&](const Value* alternative) {
        return member_schema(*alternative, member.key);
      });
      if (other == all.end()) continue;
      report_.error(member.place, child(pointer, member.key), mixed(member.key, chosen, **other));
      settled.find("properties")->set(member.key, {Object{}});
    }
  }

  Report& report_;
};

/// The value and its settled schema at the end of `path`, and the pointer to them.
struct Spot {
  const Value* schema;
  const Value* value;
  std::string pointer;
};

Spot follow(const std::vector<std::string>& path, Spot spot) {
  for (const std::string& part : path) {
    if (const json::Array* items = spot.value->get_if<json::Array>()) {
      std::size_t index = 0;
      std::from_chars(part.data(), part.data() + part.size(), index);
      const Value* schema = spot.schema->find("items");
      if (const json::Array* each = schema->get_if<json::Array>()) schema = &(*each)[index];
      spot = {schema, &(*items)[index], child(spot.pointer, index)};
    } else {
      spot = {member_schema(*spot.schema, part), spot.value->find(part), child(spot.pointer, part)};
    }
  }
  return spot;
}

/// The keys that are missing or unknown; false where the keys are not what is wrong.
bool explain_keys(const Spot& spot, Report& report) {
  const Object* members = spot.value->get_if<Object>();
  if (!members) return false;
  bool explained = false;
  for (const std::string& key : required_keys(*spot.schema)) {
    if (spot.value->find(key)) continue;
    const Value& missing = *member_schema(*spot.schema, key);
    report.error(spot.value->place, spot.pointer, "missing key \"" + key + "\". " + description(missing));
    explained = true;
  }
  const std::vector<std::string> known = property_keys(*spot.schema);
  for (const Member& member : *members) {
    if (member_schema(*spot.schema, member.key)) continue;
    report.error(member.place, child(spot.pointer, member.key), unknown_name("key", member.key, known));
    explained = true;
  }
  return explained;
}

void explain(const Spot& spot, Report& report) {
  if (explain_keys(spot, report)) return;
  const std::string about = description(*spot.schema);
  report.error(spot.value->place, spot.pointer,
               "expected " + describe_with_unit(*spot.schema) + ", got " + excerpt(*spot.value) +
                   (about.empty() ? "" : ". " + about));
}

}  // namespace

void check_shape(const Value& schema, const Value& value, const std::string& pointer, Report& report) {
  const Value settled = Settler(report).settle(schema, value, pointer);
  std::set<std::vector<std::string>> explained;
  for (const ShapeFailure& failure : validate(dump(settled), dump(value))) {
    if (explained.insert(failure.path).second)
      explain(follow(failure.path, {&settled, &value, pointer}), report);
  }
}

}  // namespace gnomon::scene
