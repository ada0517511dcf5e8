// SPDX-License-Identifier: MIT
#include "scene/project.h"

#include "scene/scratch_project.h"

namespace gnomon::scene {
namespace {

namespace fs = std::filesystem;

using ProjectFile = ScratchProject;
using Containment = ScratchProject;

TEST_F(ProjectFile, IsTheNearestUpwards) {
  const std::string file = write("testcases/a/b/c.json", "");
  const Result<Project> project = find_project(file);
  ASSERT_TRUE(project);
  EXPECT_TRUE(project->has_file);
  EXPECT_EQ(project->root, root.generic_string());
  EXPECT_EQ(project->scenes, (root / "testcases").generic_string());
  EXPECT_EQ(test_id(*project, file), "a/b/c");
  EXPECT_EQ(golden_file(*project, "a/b/c@q=1"), (root / "goldens/a/b/c@q=1.exr").generic_string());
  write("testcases/a/gnomon.json",
        "{\"version\": 1, \"scenes\": \".\", \"goldens\": \"g\", \"includes\": [\"x\"]}");
  const Result<Project> nearer = find_project(file);
  ASSERT_TRUE(nearer);
  EXPECT_EQ(test_id(*nearer, file), "b/c");
  EXPECT_EQ(golden_file(*nearer, "b/c"), (root / "testcases/a/g/b/c.exr").generic_string());
  EXPECT_EQ(nearer->includes, std::vector<std::string>{(root / "testcases/a/x").generic_string()});
}

TEST_F(ProjectFile, IdsOutsideTheScenesFolderCountFromTheRoot) {
  EXPECT_EQ(test_id(*find_project(root.generic_string()), write("extra/x.y.json", "")), "extra/x.y");
}

TEST_F(ProjectFile, WithoutOneTheScenesFolderIsTheRoot) {
  fs::remove(root / "gnomon.json");
  const std::string file = write("lone/s.json", "");
  const Result<Project> project = find_project(file);
  ASSERT_TRUE(project);
  EXPECT_FALSE(project->has_file);
  EXPECT_EQ(project->root, (root / "lone").generic_string());
  EXPECT_EQ(test_id(*project, file), "s");
}

TEST_F(ProjectFile, MistakesAreLocated) {
  const std::string file =
      write("gnomon.json", "{\n\"scenes\": \"../x\", \"goldens\": \"/tmp\",\n\"version\": 1\n}");
  const Result<Project> escaping = find_project(root.generic_string());
  ASSERT_FALSE(escaping);
  ASSERT_EQ(escaping.diagnostics().size(), 2U);
  EXPECT_EQ(to_string(escaping.diagnostics()[0]),
            file +
                ":2:11: error: /scenes: expected a folder inside the project, relative to the folder of "
                "gnomon.json, got \"../x\"");
  EXPECT_EQ(to_string(escaping.diagnostics()[1]),
            file +
                ":2:30: error: /goldens: expected a folder inside the project, relative to the folder of "
                "gnomon.json, got \"/tmp\"");
  write("gnomon.json", "{\"sceens\": 1}");
  const LoadResult result = load(scene());
  ASSERT_EQ(result.diagnostics.size(), 2U);
  EXPECT_EQ(to_string(result.diagnostics[0]),
            file + ":1:1: error: missing key \"version\". Version of the project format.");
  EXPECT_EQ(to_string(result.diagnostics[1]),
            file + ":1:2: error: /sceens: unknown key \"sceens\"; did you mean \"scenes\"?");
}

TEST_F(Containment, AFileInsideTheRootIsFound) {
  write("maps/m.png", "x");
  const LoadResult result = load(scene("", "{\"file\": \"../maps/m.png\"}"));
  ASSERT_EQ(result.tests.size(), 1U);
  EXPECT_EQ(std::get<FileTerrain>(result.tests[0].terrain.source).path,
            (root / "testcases/../maps/m.png").generic_string());
  EXPECT_NE(result.tests[0].canonical_json.find("\"file\":\"maps/m.png\""), std::string::npos);
}

TEST_F(Containment, MissingFilesAndFoldersAreErrors) {
  EXPECT_EQ(
      errors(scene("", "{\"file\": \"m.png\"}")),
      "s.json:2:21: error: /terrain/file: there is no file " + (root / "testcases/m.png").generic_string());
  EXPECT_EQ(
      errors(scene("", "{\"file\": \"..\"}")),
      "s.json:2:21: error: /terrain/file: " + (root / "testcases/..").generic_string() + " is not a file");
}

TEST_F(Containment, NothingOutsideTheRootIsReachedNorRevealed) {
  const std::string leaves =
      "s.json:2:21: error: /terrain/file: the path leads out of the project (the folder of gnomon.json, else "
      "that of "
      "the scene)";
  const fs::path outside = root.parent_path() / (root.filename().string() + "_outside");
  fs::create_directories(outside);
  std::ofstream(outside / "secret.png") << "x";
  fs::create_directories(root / "testcases");
  fs::create_symlink(outside / "secret.png", root / "testcases/link.png");
  fs::create_directory_symlink(outside, root / "testcases/folder");
  fs::create_symlink("loop.png", root / "testcases/loop.png");
  const std::string up = "../../" + outside.filename().string();
  for (const std::string& name :
       {up + "/secret.png", up + "/absent.png", std::string("link.png"), std::string("folder/secret.png"),
        std::string("folder/absent.png"), std::string("loop.png"), std::string("absent/../../../x.png")}) {
    EXPECT_EQ(errors(scene("", "{\"file\": \"" + name + "\"}")), leaves) << name;
  }
  fs::remove_all(outside);
}

TEST_F(Containment, AbsolutePathsAreRefusedEvenInside) {
  const std::string inside = write("testcases/m.png", "x");
  EXPECT_EQ(
      errors(scene("", "{\"file\": \"" + inside + "\"}")),
      "s.json:2:21: error: /terrain/file: the path is absolute; expected one relative to the scene file");
  EXPECT_EQ(errors(scene("", "{\"file\": \"m.png\\u0000\"}")),
            "s.json:2:21: error: /terrain/file: the path contains a NUL character");
}

TEST_F(Containment, ALinkThatStaysInsideIsFollowed) {
  write("maps/m.png", "x");
  fs::create_directories(root / "testcases");
  fs::create_symlink("../maps/m.png", root / "testcases/link.png");
  EXPECT_EQ(errors(scene("", "{\"file\": \"link.png\"}")), "");
}

TEST_F(ProjectFile, SceneFilesThatCannotBeReadAreErrors) {
  const auto message = [&](const std::string& path) {
    return load_scene(path, {}, vocabulary).diagnostics.at(0).message;
  };
  EXPECT_EQ(message((root / "none.json").generic_string()), "there is no such file");
  EXPECT_EQ(message(root.generic_string()), "this is a folder; expected a JSON file");
  EXPECT_EQ(message(""), "there is no such file");
}

}  // namespace
}  // namespace gnomon::scene
