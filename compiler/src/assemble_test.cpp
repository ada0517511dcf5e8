// SPDX-License-Identifier: MIT
#include <algorithm>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Assemble : public testing::Test {
 protected:
  std::string text_of(const std::string& path) const {
    const auto assembled = assemble(path, options);
    return assembled ? assembled->text : error_of(path);
  }
  std::string error_of(const std::string& path) const {
    const auto assembled = assemble(path, options);
    return assembled ? "no error" : tree.relative(to_string(assembled.diagnostics().front()));
  }
  static size_t count(const std::string& text, const std::string& part) {
    size_t times = 0;
    for (size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++times;
    return times;
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Assemble, VersionIsTheTargetsAndDefinesFollowIt) {
  options.defines = {{"A", "1"}, {"B", "vec2(1, 2)"}};
  const std::string path = tree.file("a.frag", "// first\n#version 330 core\nfloat x;\n");
  EXPECT_EQ(text_of(path), "#version 450 core\n#define A 1\n#define B vec2(1, 2)\n// first\nfloat x;\n");
}

TEST_F(Assemble, EveryLineHasItsOrigin) {
  tree.file("b.glsl", "int b1;\nint b2;\n");
  const std::string path = tree.file("a.frag", "int a1;\n#include \"b.glsl\"\nint a3;\n");
  const auto assembled = assemble(path, options);
  ASSERT_TRUE(assembled);
  EXPECT_EQ(std::ranges::count(assembled->text, '\n'), static_cast<long>(assembled->origins.size()));
  EXPECT_EQ(assembled->files, (std::vector<std::string>{path, tree.path("b.glsl")}));
  EXPECT_EQ(tree.relative(to_string(locate(*assembled, 3, "here"))),
            "b.glsl:1: error: here\n  included from a.frag:2");
  EXPECT_EQ(tree.relative(to_string(locate(*assembled, 5, "here"))), "a.frag:3: error: here");
  EXPECT_EQ(tree.relative(to_string(locate(*assembled, 1000, "here"))), "a.frag:3: error: here");
}

TEST_F(Assemble, LooksBesideTheFileThenInTheLibraryThenInIncludeFolders) {
  options.include_directories = {tree.path("extra")};
  tree.file("library/core/x.glsl", "int library_x;\n");
  tree.file("extra/gnomon/core/x.glsl", "int never;\n");
  tree.file("extra/gnomon/core/y.glsl", "int extra_y;\n");
  tree.file("extra/z.glsl", "int extra_z;\n");
  tree.file("sub/z.glsl", "int own_z;\n");
  tree.file("sub/b.glsl", "#include \"z.glsl\"\n#include <z.glsl>\n");
  const std::string path = tree.file(
      "a.frag",
      "#include <gnomon/core/x.glsl>\n#include <gnomon/core/y.glsl>\n # include \"sub/b.glsl\" // three\n");
  EXPECT_EQ(text_of(path), "#version 450 core\nint library_x;\nint extra_y;\nint own_z;\nint extra_z;\n");
}

TEST_F(Assemble, MissingIncludeNamesThePlaces) {
  options.include_directories = {tree.path("extra")};
  EXPECT_EQ(
      error_of(tree.file("a.frag", "\n#include \"none.glsl\"\n")),
      "a.frag:2: error: cannot find the include file \"none.glsl\": looked for none.glsl, extra/none.glsl; "
      "correct the name or name its folder with -I");
  tree.file("b.glsl", "#include <gnomon/relief/none.glsl>\n");
  EXPECT_EQ(error_of(tree.file("a.frag", "#include \"b.glsl\"\n")),
            "b.glsl:1: error: cannot find the include file \"gnomon/relief/none.glsl\": looked for "
            "library/relief/none.glsl, extra/gnomon/relief/none.glsl; correct the name or name its folder "
            "with -I; gnomonc list names "
            "what the library has\n"
            "  included from a.frag:1");
}

TEST_F(Assemble, MalformedInclude) {
  for (const std::string argument : {"", "b.glsl", "\"b.glsl", "<b.glsl\"", "\"\"", "\"b.glsl\" x"}) {
    EXPECT_EQ(error_of(tree.file("a.frag", "#include " + argument)),
              "a.frag:1: error: malformed #include: expected \"FILE\" or <FILE> and nothing behind it; "
              "macros are not expanded here");
  }
}

TEST_F(Assemble, CycleIsAnErrorInSpiteOfGuards) {
  const std::string path = tree.file("a.frag", "#include \"b.glsl\"\n");
  tree.file("b.glsl", "#ifndef B\n#define B\n#include \"c.glsl\"\n#endif\n");
  tree.file("c.glsl", "#ifndef C\n#define C\n\n#include \"./b.glsl\"\n#endif\n");
  EXPECT_EQ(error_of(path),
            "c.glsl:4: error: include cycle: b.glsl -> c.glsl -> b.glsl; include guards do not mend it, "
            "remove one of "
            "these\n  included from b.glsl:3\n  included from a.frag:1");
  EXPECT_EQ(error_of(tree.file("self.frag", "#include \"self.frag\"\n")),
            "self.frag:1: error: include cycle: self.frag -> self.frag; include guards do not mend it, "
            "remove one of "
            "these");
}

TEST_F(Assemble, GuardedFileIsInlinedOnce) {
  tree.file("g.glsl", "// about\n#ifndef G\n#define G\nint g;\n#endif\n");
  tree.file("b.glsl", "#include \"g.glsl\"\n");
  EXPECT_EQ(count(text_of(tree.file("a.frag", "#include \"g.glsl\"\n#include \"b.glsl\"\n")), "int g;"), 1u);
}

// Only the GLSL compiler knows whether the first one counted.
TEST_F(Assemble, GuardedFileUnderAConditionalIsInlinedAgain) {
  tree.file("g.glsl", "#ifndef G\n#define G\nint g;\n#endif\n");
  const std::string path =
      tree.file("a.frag", "#ifdef NEVER\n#include \"g.glsl\"\n#endif\n#include \"g.glsl\"\n");
  EXPECT_EQ(count(text_of(path), "int g;"), 2u);
}

TEST_F(Assemble, FileThatIsNotWhollyGuardedIsInlinedAgain) {
  tree.file("after.glsl", "#ifndef G\n#define G\n#endif\nint g;\n");
  tree.file("else.glsl", "#ifndef G\n#define G\n#else\nint g;\n#endif\n");
  tree.file("plain.glsl", "int g;\n");
  for (const std::string name : {"after.glsl", "else.glsl", "plain.glsl"}) {
    const std::string include = "#include \"" + name + "\"\n";
    EXPECT_EQ(count(text_of(tree.file("a.frag", include + include)), "int g;"), 2u) << name;
  }
}

TEST_F(Assemble, CommentsHideIncludes) {
  tree.file("b.glsl", "int b;\n");
  const std::string hidden = "// #include \"none\"\n/* \n#include \"none\"\n*/\n";
  EXPECT_EQ(text_of(tree.file("a.frag", hidden)), "#version 450 core\n" + hidden);
  EXPECT_EQ(text_of(tree.file("a.frag", "/*\n*/ #include \"b.glsl\" /*\n*/\n")),
            "#version 450 core\n/*\n*/\nint b;\n/*\n*/\n");
}

TEST_F(Assemble, DeadIncludesMayBeMissing) {
  EXPECT_NE(error_of(tree.file("a.frag", "#ifdef NEVER\n#include \"none\"\n#endif\n")), "no error");
  EXPECT_EQ(error_of(tree.file("a.frag", "#if 0\n#ifdef X\n#include \"none\"\n#endif\n#endif\n")),
            "no error");
  EXPECT_NE(error_of(tree.file("a.frag", "#if 0\n#else\n#include \"none\"\n#endif\n")), "no error");
}

TEST_F(Assemble, ConditionalsMustEndInTheirFile) {
  EXPECT_EQ(error_of(tree.file("a.frag", "int x;\n#if 1\n#ifdef A\n#endif\nint y;\n")),
            "a.frag:2: error: unterminated #if: no #endif follows in this file");
  EXPECT_EQ(error_of(tree.file("a.frag", "#if 1\n#ifndef A\n")),
            "a.frag:2: error: unterminated #ifndef: no #endif follows in this file");
  EXPECT_EQ(error_of(tree.file("a.frag", "#if 1\n#endif\n#endif\n")),
            "a.frag:3: error: #endif without #if: both have to be in the same file");
  EXPECT_EQ(error_of(tree.file("a.frag", "\n#else\n")),
            "a.frag:2: error: #else without #if: both have to be in the same file");
  EXPECT_EQ(error_of(tree.file("a.frag", "#elif 1\n")),
            "a.frag:1: error: #elif without #if: both have to be in the same file");
  EXPECT_EQ(error_of(tree.file("a.frag", "#if 1\n#else\n#else\n#endif\n")),
            "a.frag:3: error: #else after the #else of the #if in line 1");
  tree.file("open.glsl", "\n#ifdef X\n");
  EXPECT_EQ(error_of(tree.file("a.frag", "#include \"open.glsl\"\n#endif\n")),
            "a.frag:2: error: #endif without #if: both have to be in the same file");
  EXPECT_EQ(
      error_of(tree.file("a.frag", "#include \"open.glsl\"\n")),
      "open.glsl:2: error: unterminated #ifdef: no #endif follows in this file\n  included from a.frag:1");
}

TEST_F(Assemble, UnterminatedComment) {
  EXPECT_EQ(error_of(tree.file("a.frag", "/* one */\nint x; /* two\nint y;\n")),
            "a.frag:2: error: unterminated comment: no */ follows in this file");
}

TEST_F(Assemble, LineEndsByteOrderMarkAndContinuations) {
  EXPECT_EQ(text_of(tree.file("a.frag", "\xEF\xBB\xBFint a;\r\nint b;\rint c;")),
            "#version 450 core\nint a;\nint b;\nint c;\n");
  EXPECT_EQ(text_of(tree.file("a.frag", "")), "#version 450 core\n");
  const auto joined = assemble(tree.file("a.frag", "#define A 1 + \\\r\n 2\nint c;\n"), options);
  ASSERT_TRUE(joined);
  EXPECT_EQ(joined->text, "#version 450 core\n#define A 1 +  2\nint c;\n");
  EXPECT_EQ(joined->origins[2].line, 3);
}

TEST_F(Assemble, BytesThatAreNoText) {
  using namespace std::string_literals;
  EXPECT_EQ(error_of(tree.file("a.frag", "int a;\n// \0\n"s)),
            "a.frag:2: error: this line has a NUL character: the file is not text, or is damaged");
  for (const std::string bad : {"\xFF", "\xC0\xAF", "\xED\xA0\x80", "\xE2\x82", "\xF5\x80\x80\x80"}) {
    EXPECT_EQ(
        error_of(tree.file("a.frag", "// caf\xC3\xA9 \xE2\x82\xAC \xF0\x9F\x8C\x84\n\n// " + bad + "\n")),
        "a.frag:3: error: this line has a byte that is not UTF-8: save the file as UTF-8");
  }
}

TEST_F(Assemble, OnlyTheMainFileHasAVersion) {
  tree.file("b.glsl", "#version 450\n");
  EXPECT_EQ(error_of(tree.file("a.frag", "#include \"b.glsl\"\n")),
            "b.glsl:1: error: #version in an included file: only the main file may have one; remove it\n"
            "  included from a.frag:1");
}

TEST_F(Assemble, ForeignLineAndIncludeDirectivesAreDropped) {
  EXPECT_EQ(text_of(tree.file("a.frag",
                              "#line 100\n#extension GL_GOOGLE_include_directive : require\n"
                              "#extension GL_ARB_gpu_shader5 : enable\n")),
            "#version 450 core\n#extension GL_ARB_gpu_shader5 : enable\n");
}

TEST_F(Assemble, NestingAndNumberAreLimited) {
  for (int i = 0; i < 70; ++i) {
    tree.file(std::to_string(i) + ".glsl", "#include \"" + std::to_string(i + 1) + ".glsl\"\n");
  }
  EXPECT_TRUE(error_of(tree.path("0.glsl"))
                  .starts_with("63.glsl:1: error: includes are nested more than 64 deep: is there a chain "
                               "that does not end?\n"));
  for (int i = 0; i < 40; ++i) {
    const std::string include = "#include \"" + std::to_string(i + 1) + ".glsl\"\n";
    tree.file(std::to_string(i) + ".glsl", include + include);
  }
  tree.file("40.glsl", "\n");
  EXPECT_NE(error_of(tree.path("0.glsl")).find("more than 10000 files are inlined"), std::string::npos);
}

TEST_F(Assemble, PragmaOnceIsAGuard) {
  tree.file("m.glsl", "#pragma once\nfloat m() { return 1.0; }\n");
  const auto built =
      build(tree.file("a.frag",
                      "#ifdef NEVER\n#include \"m.glsl\"\n#endif\n#include \"m.glsl\"\n#include \"m.glsl\"\n"
                      "out vec4 o;\nvoid main() { o = vec4(m()); x; }\n"),
            options);
  ASSERT_FALSE(built);
  EXPECT_EQ(tree.relative(to_string(built.diagnostics().front())),
            "a.frag:7: error: 'x': undeclared identifier");
}

TEST_F(Assemble, UnreadableMainFileAndUnknownTargetAreInvalidInput) {
  for (const std::string& path : {tree.path("none.frag"), tree.path("")}) {
    const auto assembled = assemble(path, options);
    ASSERT_FALSE(assembled);
    EXPECT_EQ(assembled.diagnostics().front().failure, Failure::kInvalid);
  }
  options.target = "cobol";
  EXPECT_EQ(error_of(tree.file("a.frag", "")),
            "error: unknown target \"cobol\": known are glsl450, glsl330, essl300, essl310, vulkan, opengl, "
            "hlsl50, "
            "msl21 and header");
}

TEST_F(Assemble, AnUndefinedGuardLetsTheFileInAgain) {
  tree.file("b.glsl", "#ifndef B\n#define B\nint b;\n#endif\n");
  tree.file("c.glsl", "#ifndef C\n#define C\nint c;\n#undef C\n#endif\n");
  const std::string include = "#include \"b.glsl\"\n#include \"c.glsl\"\n";
  const std::string text = text_of(tree.file("a.frag", include + include + "#undef B\n" + include));
  EXPECT_EQ(count(text, "int b;"), 2u);
  EXPECT_EQ(count(text, "int c;"), 3u);
}

TEST_F(Assemble, PragmaOnceIsNotHandedOn) {
  tree.file("b.glsl", "#pragma once /* kept: a\nb */\nint b;\n");
  const std::string text = text_of(tree.file("a.frag", "#include \"b.glsl\"\n#include \"b.glsl\"\n"));
  EXPECT_EQ(count(text, "once"), 0u) << text;
  EXPECT_EQ(count(text, "int b;"), 1u) << text;
}

}  // namespace
}  // namespace gnomon::compiler
