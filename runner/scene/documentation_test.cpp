// SPDX-License-Identifier: MIT
// docs/scene.md says of every key what the schema says.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "scene/scene.h"
#include "scene/schema.h"

namespace gnomon::scene {
namespace {

using json::Value;

std::string default_of(const Value& node, bool required) {
  const Value* written = node.find("default");
  return written ? "`" + dump(*written) + "`" : required ? "required" : "–";
}

std::string row(const std::string& key, const Value& node, bool required) {
  const Value* unit = node.find("unit");
  return "| `" + key + "` | " + describe(node) + " | " + (unit ? unit->text() : "–") + " | " +
         default_of(node, required) + " | " + description(node) + " |";
}

void add_rows(const Value& node, const std::string& prefix, std::set<std::string>& rows);

void add_member(const std::string& key, const Value& member, bool required, std::set<std::string>& rows) {
  const Value& node = resolve(member);
  rows.insert(row(key, node, required));
  add_rows(node, key + ".", rows);
}

void add_rows(const Value& node, const std::string& prefix, std::set<std::string>& rows) {
  for (const Value* alternative : alternatives(node)) {
    const std::vector<std::string> required = required_keys(*alternative);
    for (const std::string& key : property_keys(*alternative)) {
      const bool is_required = std::find(required.begin(), required.end(), key) != required.end();
      add_member(prefix + key, *member_schema(*alternative, key), is_required, rows);
    }
    const Value* others = alternative->find("additionalProperties");
    if (others && others->find("$ref")) {
      rows.insert(row(prefix + "NAME", resolve(*others), false));  // its keys have their rows elsewhere
    } else if (others && !description(*others).empty()) {
      add_member(prefix + "NAME", *others, false, rows);
    }
    const Value* items = alternative->find("items");
    if (items && (items->find("oneOf") || items->find("properties"))) add_rows(*items, prefix + "N.", rows);
  }
}

std::set<std::string> documented_rows() {
  std::ifstream file(GNOMON_SOURCE_DIR "/docs/scene.md");
  std::set<std::string> rows;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("| `")) rows.insert(line);
  }
  return rows;
}

std::string listing(const std::set<std::string>& rows) {
  std::string text;
  for (const std::string& one : rows) text += one + "\n";
  return text;
}

TEST(SceneReference, HasOneRowForEachKeyOfTheSchemaAndNoOther) {
  std::set<std::string> expected;
  add_rows(scene_schema(), "", expected);
  add_rows(project_schema(), "", expected);
  EXPECT_EQ(listing(documented_rows()), listing(expected));
}

void expect_documented(const Value& node, const std::string& key) {
  for (const Value* alternative : alternatives(node)) {
    for (const std::string& name : property_keys(*alternative)) {
      const Value& member = *member_schema(*alternative, name);
      EXPECT_FALSE(description(member).empty()) << key + name;
      expect_documented(member, key + name + ".");
    }
    const Value* items = alternative->find("items");
    if (items && items->get_if<json::Object>()) expect_documented(*items, key + "N.");
  }
}

TEST(SceneSchema, DescribesEveryKey) {
  expect_documented(scene_schema(), "");
  expect_documented(project_schema(), "gnomon.json: ");
}

TEST(SceneSchema, DefaultsAreThoseOfTheScene) {
  const auto default_at = [](const Value& node, const char* key) -> const Value& {
    return *resolve(*member_schema(node, key)).find("default");
  };
  const Value& sun = *alternatives(*member_schema(scene_schema(), "sun")).front();
  const Value& shadow = *member_schema(scene_schema(), "shadow");
  const Value& terrain = *alternatives(*member_schema(scene_schema(), "terrain")).front();
  EXPECT_EQ(default_at(sun, "azimuth").number(), Sun{}.azimuth);
  EXPECT_EQ(default_at(sun, "elevation").number(), Sun{}.elevation);
  const Value& sun_by_time = *alternatives(*member_schema(scene_schema(), "sun")).back();
  EXPECT_EQ(std::get<bool>(default_at(sun_by_time, "refraction").data), SunTime{}.refraction);
  EXPECT_EQ(default_at(shadow, "method").text(), Shadow{}.method);
  EXPECT_EQ(default_at(shadow, "q").number(), Shadow{}.q);
  EXPECT_EQ(default_at(shadow, "k_dark").number(), Shadow{}.k_dark);
  EXPECT_EQ(default_at(shadow, "k_bright").number(), Shadow{}.k_bright);
  EXPECT_EQ(default_at(shadow, "receiver_height").number(), Shadow{}.receiver_height);
  const Value& cascades = *member_schema(shadow, "cascades");
  EXPECT_EQ(default_at(cascades, "count").number(), Cascades{}.count);
  EXPECT_EQ(default_at(cascades, "size").number(), Cascades{}.size);
  EXPECT_EQ(default_at(cascades, "split").number(), Cascades{}.split);
  EXPECT_EQ(default_at(cascades, "bias").number(), Cascades{}.bias);
  EXPECT_EQ(default_at(cascades, "slope_bias").number(), Cascades{}.slope_bias);
  EXPECT_EQ(default_at(cascades, "filter").number(), Cascades{}.filter);
  EXPECT_EQ(std::get<bool>(default_at(cascades, "stable").data), Cascades{}.stable);
  EXPECT_EQ(default_at(cascades, "faces").text() == "all", Cascades{}.faces == Cascades::Faces::kAll);
  EXPECT_EQ(default_at(cascades, "step").number(), Cascades{}.step);
  EXPECT_EQ(default_at(terrain, "vertical_scale").number(), 1.0);
  EXPECT_EQ(default_at(terrain, "seed").number(), ProceduralTerrain{}.seed);
  EXPECT_EQ(default_at(terrain, "size").array()[0].number(), ProceduralTerrain{}.width);
  EXPECT_EQ(default_at(terrain, "size").array()[1].number(), ProceduralTerrain{}.height);
}

}  // namespace
}  // namespace gnomon::scene
