// SPDX-License-Identifier: MIT
#include "gnomon/compiler/depfile.h"

#include "gnomon/compiler/compiler.h"
#include "gnomon/compiler/graph.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Dependencies : public testing::Test {
 protected:
  std::string read_by(const std::string& path) const {
    std::string names;
    for (const std::string& file : files_read(path, options)) names += tree.relative(file) + " ";
    return names;
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Dependencies, RuleWithAnEmptyOneForEachInclude) {
  EXPECT_EQ(to_depfile("o", {"a.frag"}), "o: \\\n  a.frag\n");
  EXPECT_EQ(to_depfile("o", {"a.frag", "b", "c"}), "o: \\\n  a.frag \\\n  b \\\n  c\nb:\nc:\n");
}

TEST_F(Dependencies, WhatMakeTakesForSyntaxIsEscaped) {
  EXPECT_EQ(to_depfile("my o", {"a #1$.frag"}), "my\\ o: \\\n  a\\ \\#1$$.frag\n");
  EXPECT_EQ(to_depfile("o", {"a\\b:c.frag"}), "o: \\\n  a\\b\\:c.frag\n");
  EXPECT_EQ(to_depfile("o", {"a\\ b"}), "o: \\\n  a\\\\\\ b\n");
}

TEST_F(Dependencies, FilesAreKnownThoughTheShaderIsWrong) {
  tree.file("b.glsl", "float b;\n");
  const std::string missing = tree.file("a.frag", "#include \"b.glsl\"\n#include \"none.glsl\"\n");
  EXPECT_EQ(read_by(missing), "a.frag b.glsl none.glsl ");
  tree.file("open.glsl", "#if 1\n");
  EXPECT_EQ(read_by(tree.file("c.frag", "#include \"open.glsl\"\n")), "c.frag open.glsl ");
  EXPECT_EQ(read_by(tree.file("d.frag", "#include \"b.glsl\"\nerror\n")), "d.frag b.glsl ");
}

TEST_F(Dependencies, GraphHasAnEdgeForEveryIncludeThoughGuardedFilesAreInlinedOnce) {
  const std::string guarded = "#ifndef G\n#define G\n#include \"d.glsl\"\n#endif\n";
  tree.file("c.glsl", guarded);
  tree.file("d.glsl", "float d;\n");
  tree.file("b.glsl", "#include \"c.glsl\"\n#include \"c.glsl\"\n");
  const auto assembled = assemble(tree.file("a.frag", "#include \"b.glsl\"\n#include \"c.glsl\"\n"), options);
  ASSERT_TRUE(assembled);
  EXPECT_EQ(tree.relative(to_tree(*assembled)), "a.frag\n  b.glsl\n    c.glsl\n      d.glsl\n  c.glsl\n");
  const std::string dot = tree.relative(to_dot(*assembled));
  for (const char* part :
       {"\"b.glsl\" -> \"c.glsl\";", "\"a.frag\" -> \"c.glsl\";", "\"c.glsl\" -> \"d.glsl\";"})
    EXPECT_NE(dot.find(part), dot.npos) << dot;
  EXPECT_EQ(dot.find("\"a.frag\" -> \"d.glsl\""), dot.npos);
}

}  // namespace
}  // namespace gnomon::compiler
