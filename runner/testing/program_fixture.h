// SPDX-License-Identifier: MIT
// What tests of the program as a user meets it share.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "shell.h"
#include "testing/run_command.h"

namespace gnomon::testing {

namespace fs = std::filesystem;

/// An empty folder with a project of its own, and the program run inside it.
class Gnomon : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    root_ = fs::path(::testing::TempDir()) / (std::string("gnomon_test_") + test->name());
    fs::remove_all(root_);
    fs::create_directories(root_);
    write("gnomon.json", R"({"version": 1})");
  }
  void TearDown() override { fs::remove_all(root_); }

  void write(const std::string& name, const std::string& text) {
    fs::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << text;
  }

  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(root_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  [[nodiscard]] Ran run(const std::string& arguments) const {
    return run_command("cd " + quote(root_.string()) + " && " + quote(program_) + " " + arguments);
  }

  /// A scene over a fractal of `size` samples a side.
  void write_scene(const std::string& name, const std::string& expect, int size = 96) {
    write("testcases/" + name + ".json",
          R"({"version": 1, "description": "d", "terrain": {"procedural": "fractal", "size": [)" +
              std::to_string(size) + "," + std::to_string(size) +
              R"(], "spacing": 10}, "sun": {"azimuth": 200, "elevation": 10}, "expect": )" + expect + "}");
  }

  /// A copy of the program with a shader library of its own, which a test may damage.
  void install() {
    fs::create_directories(root_ / "bin");
    fs::create_directories(root_ / "share");
    fs::copy_file(GNOMON_PROGRAM, root_ / "bin/gnomon");
    fs::copy(GNOMON_SOURCE_DIR "/shaderlib", root_ / "share/gnomon", fs::copy_options::recursive);
    program_ = (root_ / "bin/gnomon").string();
  }

  void replace(const std::string& name, const std::string& from, const std::string& to) {
    std::string text = read(name);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << name << " has no '" << from << "'";
    write(name, text.replace(at, from.size(), to));
  }

  fs::path root_;
  std::string program_ = GNOMON_PROGRAM;
};

}  // namespace gnomon::testing
