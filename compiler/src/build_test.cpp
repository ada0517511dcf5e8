// SPDX-License-Identifier: MIT
#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Build : public testing::Test {
 protected:
  std::string error_of(const std::string& path) const {
    const auto built = build(path, options);
    if (built) return "no error";
    EXPECT_EQ(built.diagnostics().size(), 1u);
    return tree.relative(to_string(built.diagnostics().front()));
  }
  std::string error_in(const std::string& text) const { return error_of(tree.file("a.frag", text)); }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Build, YieldsWhatWasAssembled) {
  const std::string path = tree.file("a.frag", "out vec4 color;\nvoid main() { color = vec4(1.0f); }");
  const auto built = build(path, options);
  ASSERT_TRUE(built);
  EXPECT_EQ(built->output, assemble(path, options)->text);
  EXPECT_TRUE(built->source.warnings.empty());
}

TEST_F(Build, ErrorThreeIncludesDeep) {
  const std::string path =
      tree.file("a.frag", "#version 330\n\n#include \"b/b.glsl\"\nvoid main() { deep(); }\n");
  tree.file("b/b.glsl", "float b;\r\n#include \"c.glsl\"\r\n");
  tree.file("b/c.glsl", "#ifndef C\n#define C\n#include <gnomon/core/d.glsl>\n#endif");
  tree.file("library/core/d.glsl", "#define LONG 1 + \\\n  2\nfloat deep() {\n  return missing;\n}");
  EXPECT_EQ(error_of(path),
            "library/core/d.glsl:4: error: 'missing': undeclared identifier\n"
            "  included from b/c.glsl:3\n  included from b/b.glsl:2\n  included from a.frag:3");
}

TEST_F(Build, SyntaxErrorsAreSpelt) {
  EXPECT_EQ(error_in("void main() {\n  int x = 1\n  int y;\n}\n"),
            "a.frag:3: error: syntax error: found 'int' where ',' or ';' was expected; a ';' is missing "
            "before it, or a keyword is used as a name");
  EXPECT_EQ(error_in("void main() {\n"),
            "a.frag:1: error: syntax error: the file ends too early; a '}' or ')' is missing");
  EXPECT_EQ(error_in("void main() {\n  foo = 1;\n  bar = 2;\n}\n"),
            "a.frag:2: error: 'foo': undeclared identifier");
  EXPECT_EQ(error_in("void main() {\n  float x = vec3(1);\n}\n"),
            "a.frag:2: error: cannot convert from 'vec3' to 'float'");
  EXPECT_EQ(error_in("\n#error no such mode\nvoid main() {}\n"), "a.frag:2: error: #error: no such mode");
}

TEST_F(Build, ErrorsInADefineAreOnTheCommandLineOrWhereItIsUsed) {
  options.defines = {{"A", "missing"}};
  EXPECT_EQ(error_in("void main() {\n  float x = A;\n}\n"),
            "a.frag:2: error: 'missing': undeclared identifier, in the expansion of the macro A");
  options.defines = {{"A", "1"}, {"A", "2"}};
  EXPECT_TRUE(error_in("void main() {}\n").starts_with("<command line>: error: "));
}

TEST_F(Build, DefinesDecide) {
  const std::string text = "#if MODE == 2\nvoid main() {}\n#else\n#error wrong mode\n#endif\n";
  EXPECT_EQ(error_in(text), "a.frag:4: error: #error: wrong mode");
  options.defines = {{"MODE", "2"}};
  EXPECT_EQ(error_in(text), "no error");
}

TEST_F(Build, UndefinedHostFunctionIsNamedAtItsPrototype) {
  tree.file("library/core/map.glsl",
            "// float gnomon_host_height(int) is for the host\nfloat far(int x);\n"
            "float gnomon_host_height(ivec2 at,\n  int q);\n"
            "float height() { return gnomon_host_height(ivec2(1), 0); }\n");
  const std::string prefix = "#include <gnomon/core/map.glsl>\nout float o;\n";
  EXPECT_EQ(
      error_in(prefix + "void main() { o = height(); }\n"),
      "library/core/map.glsl:3: error: function 'gnomon_host_height' is declared and called, but not "
      "defined: "
      "define it, or include a ready-made host such as <gnomon/host/r32f.glsl>\n  included from a.frag:1");
  EXPECT_EQ(
      error_in(prefix + "void main() { o = far(1); }\n"),
      "library/core/map.glsl:2: error: function 'far' is declared and called, but not defined: define it, or "
      "include the file that does\n  included from a.frag:1");
  EXPECT_EQ(error_in(prefix + "float gnomon_host_height(ivec2 at, int q) { return 1.0f; }\n"
                              "void main() { o = height(); }\n"),
            "no error");
}

TEST_F(Build, UndefinedFunctionBehindAMacroIsLocatedAtItsCall) {
  EXPECT_EQ(
      error_in("#define DECLARE(name) float name(int x)\nDECLARE(hidden);\nout float o;\n"
               "void main() {\n  o = hidden(1);\n}\n"),
      "a.frag:5: error: function 'hidden' is declared and called, but not defined: define it, or include the "
      "file that does");
}

TEST_F(Build, RecursionIsLocated) {
  EXPECT_EQ(error_in("out float o;\nfloat f(float x) {\n  return f(x);\n}\nvoid main() { o = f(1.0f); }\n"),
            "a.frag:2: error: function 'f' calls itself, directly or through others: GLSL has no recursion, "
            "write a "
            "loop with a bound");
}

TEST_F(Build, ModuleIsRefusedAndCheckNamed) {
  const auto built = build(tree.file("m.frag", "float f() { return 1.0f; }\n"), options);
  ASSERT_FALSE(built);
  EXPECT_EQ(built.diagnostics().front().failure, Failure::kInvalid);
  EXPECT_EQ(tree.relative(to_string(built.diagnostics().front())),
            "m.frag: error: has no main(): it is a module, not a shader; use gnomonc check");
}

TEST_F(Build, StageComesFromTheExtensionOrTheOptions) {
  const std::string text = "void main() { gl_Position = vec4(0.0f); }\n";
  EXPECT_EQ(error_of(tree.file("a.vert", text)), "no error");
  EXPECT_EQ(error_of(tree.file("a.frag", text)), "a.frag:1: error: 'gl_Position': undeclared identifier");
  const auto unknown = build(tree.file("a.glsl", text), options);
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.diagnostics().front().failure, Failure::kInvalid);
  options.stage = Stage::kVertex;
  EXPECT_EQ(error_of(tree.path("a.glsl")), "no error");
  options.stage = std::nullopt;
  EXPECT_EQ(error_of(tree.file("a.comp", "layout(local_size_x = 8) in;\nvoid main() { barrier(); }\n")),
            "no error");
  EXPECT_EQ(error_of(tree.file("a.geom",
                               "layout(points) in;\nlayout(points, max_vertices = 1) out;\n"
                               "void main() { EmitVertex(); }\n")),
            "no error");
}

TEST_F(Build, WarningsOfTheGlslCompilerAreLocated) {
  tree.file("b.glsl", "\n#extension GL_FOO_bar : enable\n");
  const auto built = build(tree.file("a.frag", "#include \"b.glsl\"\nvoid main() {}\n"), options);
  ASSERT_TRUE(built);
  ASSERT_EQ(built->source.warnings.size(), 1u);
  EXPECT_EQ(tree.relative(to_string(built->source.warnings.front())),
            "b.glsl:2: warning: #extension GL_FOO_bar: there is no such extension here: correct the name, or "
            "remove the line\n  included from a.frag:1");
}

TEST_F(Build, FailuresLeaveNothingBehind) {
  const std::string good = tree.file("good.frag", "void main() {}\n");
  for (int i = 0; i < 200; ++i) {
    EXPECT_NE(error_in(i % 2 == 0 ? "float f(float x);\nvoid main() { f(1.0f); }\n" : "void main() { ) }\n"),
              "no error");
  }
  EXPECT_EQ(error_of(good), "no error");
}

TEST_F(Build, HugeAndDeepTextsEndInAResult) {
  std::string lines;
  for (int i = 0; i < 100000; ++i) lines += "// line\n";
  EXPECT_EQ(error_in(lines + "void main() { x; }\n"), "a.frag:100001: error: 'x': undeclared identifier");
  const std::string open(20000, '(');
  EXPECT_EQ(error_in("void main() {\n  float x = " + open + "1.0" + std::string(20000, ')') + ";\n}\n"),
            "a.frag:2: error: nested too deeply for the GLSL compiler: move the inner part into a function");
  EXPECT_NE(error_in("void main() { " + std::string(1 << 20, 'x') + "; }\n"), "no error");
}

}  // namespace
}  // namespace gnomon::compiler
