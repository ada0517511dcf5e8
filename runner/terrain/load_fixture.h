// SPDX-License-Identifier: MIT
// A folder of height maps for the tests of loading them.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <string>

#include "terrain/load.h"
#include "terrain/test_files.h"

namespace gnomon::terrain {

namespace fs = std::filesystem;
using test::TestFile;

inline constexpr int kWidth = 5;
inline constexpr int kHeight = 4;

class LoadFiles : public testing::Test {
 protected:
  LoadFiles() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~LoadFiles() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string write(const std::string& name, const TestFile& file) const {
    test::write_test_file(path(name), file);
    return path(name);
  }
  std::string write_text(const std::string& name, const std::string& text) const {
    std::ofstream(path(name), std::ios::binary) << text;
    return path(name);
  }
  [[nodiscard]] std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_)) names.insert(entry.path().filename().string());
    return names;
  }

 private:
  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("gnomon-") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// 10, 11, 12 ... row by row.
inline TestFile counting(int width = kWidth, int height = kHeight) {
  TestFile file{.width = width, .height = height};
  file.values.resize(static_cast<std::size_t>(width * height));
  std::iota(file.values.begin(), file.values.end(), 10);
  return file;
}

inline TestFile utm() {
  TestFile file = counting();
  file.crs = "EPSG:32611";
  file.transform = {{380000, 30, 0, 3800000, 0, -20}};
  return file;
}

inline std::string refusal(const Result<LoadedHeightMap>& loaded) {
  if (loaded.ok()) return "nothing was refused";
  EXPECT_EQ(loaded.diagnostics()[0].failure, Failure::kInvalid);
  EXPECT_EQ(loaded.diagnostics().size(), 1u);
  return loaded.diagnostics()[0].message;
}

inline std::string notes(const LoadedHeightMap& loaded) {
  return std::accumulate(loaded.notes.begin(), loaded.notes.end(), std::string(),
                         [](const std::string& all, const std::string& one) { return all + one + "\n"; });
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
#define ASSERT_LOADS(loaded) ASSERT_TRUE((loaded).ok()) << to_string((loaded).diagnostics()[0])

}  // namespace gnomon::terrain
