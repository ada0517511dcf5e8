// SPDX-License-Identifier: MIT
#include "scene/discover.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace gnomon::scene {
namespace {

namespace fs = std::filesystem;

class FindScenes : public testing::Test {
 protected:
  FindScenes() : root(fs::path(testing::TempDir()) / "gnomon_find_scenes") {
    fs::remove_all(root);
    for (const char* name :
         {"gnomon.json", "testcases/b.json", "testcases/a/z.json", "testcases/a/.hidden/x.json",
          "testcases/a/scene.schema.json", "testcases/a/notes.txt", "other/o.json", "empty/x.txt"}) {
      fs::create_directories((root / name).parent_path());
      std::ofstream(root / name) << "{\"version\": 1}";
    }
  }
  ~FindScenes() override { fs::remove_all(root); }

  std::vector<std::string> found(const std::vector<std::string>& below) const {
    std::vector<std::string> paths;
    for (const std::string& path : below) paths.push_back((root / path).generic_string());
    const Result<std::vector<std::string>> result = find_scenes(paths, root.generic_string());
    std::vector<std::string> names;
    for (const std::string& file : result ? *result : std::vector<std::string>{}) {
      names.push_back(fs::path(file).lexically_relative(root).generic_string());
    }
    return names;
  }

  fs::path root;
};

using Names = std::vector<std::string>;

TEST_F(FindScenes, WithoutPathsTakesTheProjectsScenes) {
  EXPECT_EQ(found({}), (Names{"testcases/a/z.json", "testcases/b.json"}));
}

TEST_F(FindScenes, AProjectsRootStandsForItsScenes) {
  EXPECT_EQ(found({"."}), (Names{"testcases/a/z.json", "testcases/b.json"}));
}

TEST_F(FindScenes, TakesFilesAndFoldersSortedEachOnce) {
  EXPECT_EQ(found({"testcases/b.json", "other", "testcases/a/../b.json"}),
            (Names{"other/o.json", "testcases/b.json"}));
}

TEST_F(FindScenes, NamesEveryPathThatIsWrong) {
  const std::string missing = (root / "missing").generic_string(), empty = (root / "empty").generic_string();
  const auto result = find_scenes({missing, empty});
  ASSERT_FALSE(result);
  ASSERT_EQ(result.diagnostics().size(), 2U);
  EXPECT_EQ(to_string(result.diagnostics()[0]), missing + ": error: there is no such scene file or folder");
  EXPECT_EQ(to_string(result.diagnostics()[1]), empty + ": error: the folder holds no scene files (*.json)");
}

TEST(Filter, StarCrossesSlashes) {
  EXPECT_TRUE(matches_glob("cone*", "cone/a@q=1"));
  EXPECT_TRUE(matches_glob("*q=1", "cone/a@q=1"));
  EXPECT_TRUE(matches_glob("a/b@elevation=10,q=?", "a/b@elevation=10,q=2"));
  EXPECT_FALSE(matches_glob("cone", "cone/a"));
  EXPECT_FALSE(matches_glob("*q=1", "cone/a@q=12"));
  EXPECT_TRUE(matches_glob("*", ""));
  EXPECT_FALSE(matches_glob("?", ""));
}

TEST(Filter, ManyStarsAreNoExponentialSearch) {
  std::string glob;
  for (int i = 0; i < 200; ++i) glob += "*a";
  EXPECT_FALSE(matches_glob(glob + "b", std::string(5000, 'a')));
}

TEST(Filter, SeveralAreJoinedByOrAndExclusionsWin) {
  EXPECT_TRUE(is_chosen({}, "a"));
  EXPECT_TRUE(is_chosen({"a", "b"}, "b"));
  EXPECT_FALSE(is_chosen({"a", "b"}, "c"));
  EXPECT_TRUE(is_chosen({"!a*"}, "b"));
  EXPECT_FALSE(is_chosen({"*", "!a*"}, "ab"));
}

TEST(Shards, AreDisjointAndComplete) {
  for (std::size_t position = 0; position < 11; ++position) {
    int holders = 0;
    for (const char* text : {"1/4", "2/4", "3/4", "4/4"})
      holders += parse_shard(text)->contains(position) ? 1 : 0;
    EXPECT_EQ(holders, 1) << position;
  }
}

TEST(Shards, CountFromOne) {
  EXPECT_TRUE(parse_shard("1/1"));
  for (const char* wrong : {"0/4", "5/4", "1", "1/", "/2", "a/b", "1/2/3", "-1/2", "1/0", ""}) {
    const auto shard = parse_shard(wrong);
    ASSERT_FALSE(shard) << wrong;
    EXPECT_EQ(shard.diagnostics()[0].message,
              "--shard expects I/N with 1 <= I <= N, such as 1/4, got \"" + std::string(wrong) + "\"");
  }
}

}  // namespace
}  // namespace gnomon::scene
