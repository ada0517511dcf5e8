// SPDX-License-Identifier: MIT
#include "gnomon/compiler/modules.h"

#include "gnomon/library_location.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

TEST(Modules, HeadersAreRead) {
  const TemporaryTree tree;
  tree.file("relief/walk.glsl",
            "// SPDX-License-Identifier: MIT\n// summary: Walks: step by step.\n// source:  A paper, eq. 1;\n"
            "//          and a second one\n// host:    gnomon_host_height\n// options: SPEED (off): quicker\n"
            "// Some prose.\n#define X\n// summary: not this\n");
  tree.file("core/bare.glsl", "int x;\n// summary: too late\n");
  tree.file("programs/p.glsl", "// summary: A program is no module.\n");
  tree.file("core/notes.txt", "// summary: Not GLSL.\n");
  const auto modules = list_modules(tree.path(""));
  ASSERT_TRUE(modules);
  ASSERT_EQ(modules->size(), 2u);
  EXPECT_EQ(modules->front().name, "core/bare");
  EXPECT_EQ(modules->front().summary, "");
  const Module& walk = modules->back();
  EXPECT_EQ(walk.name, "relief/walk");
  EXPECT_EQ(walk.path, tree.path("relief/walk.glsl"));
  EXPECT_EQ(walk.summary, "Walks: step by step.");
  EXPECT_EQ(walk.source, "A paper, eq. 1; and a second one");
  EXPECT_EQ(walk.host, "gnomon_host_height");
  EXPECT_EQ(walk.options, "SPEED (off): quicker");
}

TEST(Modules, TableHasOneLineAModule) {
  EXPECT_EQ(to_table({{"a", "", "Short.", "S", "", ""}, {"long/name", "", "Longer one.", "", "", ""}}),
            "a          Short.       S\nlong/name  Longer one.  \n");
}

TEST(Modules, MissingLibrary) {
  const TemporaryTree tree;
  const auto modules = list_modules(tree.path("none"));
  ASSERT_FALSE(modules);
  EXPECT_EQ(tree.relative(to_string(modules.diagnostics().front())),
            "none: error: cannot read the shader library: No such file or directory");
}

TEST(LibraryLocation, InstalledProgramsDoNotFallBackOnTheSourceTree) {
  const TemporaryTree tree;
  const std::string program = tree.file("bin/gnomonc", "");
  const std::string library = (std::filesystem::canonical(tree.path("")) / "share/gnomon").string();
  EXPECT_EQ(shader_library(program), library);
  tree.file("share/gnomon/core/map.glsl", "");
  EXPECT_EQ(shader_library(program), library);
}

TEST(LibraryLocation, ProgramsOfTheBuildTreeTakeTheSourceTree) {
  EXPECT_EQ(shader_library(GNOMON_BUILD_BIN "/gnomonc"), GNOMON_SOURCE_SHADERLIB);
}

TEST(Modules, LinksThatGoRoundAreNone) {
  const TemporaryTree tree;
  tree.file("library/core/a.glsl", "// summary: A.\n");
  std::filesystem::create_symlink("x.glsl", tree.path("library/core/x.glsl"));
  const auto modules = list_modules(tree.path("library"));
  ASSERT_TRUE(modules);
  EXPECT_EQ(modules->size(), 1u);
}

}  // namespace
}  // namespace gnomon::compiler
