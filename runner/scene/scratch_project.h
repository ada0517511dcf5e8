// SPDX-License-Identifier: MIT
// For tests: a project in a folder of its own, removed at the end, and scenes in it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/load.h"

namespace gnomon::scene {

class ScratchProject : public testing::Test {
 protected:
  ScratchProject() {
    const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
    root = std::filesystem::path(testing::TempDir()) / ("gnomon_scene_" + std::string(info->name()));
    std::filesystem::remove_all(root);
    write("gnomon.json", "{ \"version\": 1 }");
    vocabulary.methods = {"multilevel", "brute_force", "reference"};
    vocabulary.kinds = {{"cone", {"height", "radius"}}, {"fractal", {}}};
    vocabulary.channels = {"b_shadow", "k_shadow", "steps"};
  }
  ~ScratchProject() override { std::filesystem::remove_all(root); }

  std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = root / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.generic_string();
  }

  LoadResult load(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return load_scene(write("testcases/s.json", text), overrides, vocabulary);
  }

  /// The errors, one a line, with the scene's path as "s.json".
  std::string errors(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return listing(load(text, overrides));
  }

  std::string listing(const LoadResult& result) const {
    std::string lines;
    for (const Diagnostic& diagnostic : result.diagnostics) {
      Diagnostic shown = diagnostic;
      if (shown.file == (root / "testcases/s.json").generic_string()) shown.file = "s.json";
      lines += (lines.empty() ? "" : "\n") + to_string(shown);
    }
    EXPECT_TRUE(lines.empty() || result.tests.empty()) << "an invalid scene has tests";
    return lines;
  }

  /// A valid scene with further members; `terrain` may be replaced.
  static std::string scene(const std::string& members = "",
                           const std::string& terrain = "{\"procedural\": \"cone\"}",
                           const std::string& expect = "[{\"golden\": {}}]") {
    return "{\"version\": 1, \"description\": \"d\", \"expect\": " + expect + ",\n\"terrain\": " + terrain +
           (members.empty() ? "" : ",\n" + members) + "}";
  }

  std::filesystem::path root;
  Vocabulary vocabulary;
};

}  // namespace gnomon::scene
