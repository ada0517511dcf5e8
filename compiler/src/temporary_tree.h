// SPDX-License-Identifier: MIT
// Files for one test, in a folder of their own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace gnomon {

class TemporaryTree {
 public:
  TemporaryTree() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    // With the process, so that test runs side by side do not meet.
    root_ = std::filesystem::path(testing::TempDir()) / ("gnomon-compiler-" + std::to_string(::getpid()) +
                                                         "-" + test->test_suite_name() + "-" + test->name());
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
  }
  TemporaryTree(const TemporaryTree&) = delete;
  TemporaryTree& operator=(const TemporaryTree&) = delete;
  ~TemporaryTree() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }

  /// The path of `name`, which may have folders.
  [[nodiscard]] std::string path(const std::string& name) const { return (root_ / name).string(); }

  /// Writes a file, exactly these bytes, and returns its path.
  std::string file(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((root_ / name).parent_path());
    std::ofstream(root_ / name, std::ios::binary) << bytes;
    return path(name);
  }

  [[nodiscard]] std::string read(const std::string& name) const {
    std::ostringstream bytes;
    bytes << std::ifstream(root_ / name, std::ios::binary).rdbuf();
    return bytes.str();
  }

  /// `text` without the tree's own path, so that messages can be compared whole.
  [[nodiscard]] std::string relative(std::string text) const {
    const std::string prefix = path("");
    for (size_t at = text.find(prefix); at != text.npos; at = text.find(prefix))
      text.erase(at, prefix.size());
    return text;
  }

 private:
  std::filesystem::path root_;
};

}  // namespace gnomon
