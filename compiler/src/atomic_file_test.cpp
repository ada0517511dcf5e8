// SPDX-License-Identifier: MIT
#include "gnomon/atomic_file.h"

#include <string_view>

#include "temporary_tree.h"

namespace gnomon {
namespace {

Result<Done> write(const std::string& path, std::string_view text) {
  return write_file_atomically(path, std::as_bytes(std::span(text)));
}

size_t entries(const std::string& folder) {
  const std::filesystem::directory_iterator entries(folder);
  return static_cast<size_t>(std::distance(begin(entries), end(entries)));
}

TEST(AtomicFile, ReplacesAndLeavesNothingElse) {
  const TemporaryTree tree;
  EXPECT_TRUE(write(tree.path("out"), "first, the longer one"));
  EXPECT_TRUE(write(tree.path("out"), "second"));
  EXPECT_EQ(tree.read("out"), "second");
  EXPECT_EQ(entries(tree.path("")), 1u);
}

TEST(AtomicFile, FollowsSymbolicLinks) {
  const TemporaryTree tree;
  tree.file("real", "old");
  std::filesystem::create_symlink("real", tree.path("link"));
  EXPECT_TRUE(write(tree.path("link"), "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(tree.path("link")));
  EXPECT_EQ(tree.read("real"), "new");
}

TEST(AtomicFile, DevicesStayDevices) {
  EXPECT_TRUE(write("/dev/null", "gone"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  const auto full = write("/dev/full", "too much");
  ASSERT_FALSE(full);
  EXPECT_EQ(to_string(full.diagnostics().front()),
            "/dev/full: error: cannot write the file: No space left on device");
}

TEST(AtomicFile, FailureIsTheMachines) {
  const TemporaryTree tree;
  for (const std::string& path : {tree.path("none/out"), tree.path("")}) {
    const auto written = write(path, "x");
    ASSERT_FALSE(written);
    EXPECT_EQ(written.diagnostics().front().failure, Failure::kMachine);
  }
  EXPECT_EQ(entries(tree.path("")), 0u);
}

}  // namespace
}  // namespace gnomon
