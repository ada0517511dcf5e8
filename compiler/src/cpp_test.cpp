// SPDX-License-Identifier: MIT
// Modules as C++, compiled and run by a C++ compiler.
#include "gnomon/compiler/cpp.h"

#include "temporary_program.h"

namespace gnomon::compiler {
namespace {

class Cpp : public testing::Test {
 protected:
  std::string error_of(const std::vector<std::string>& paths) const {
    const auto header = cpp_header(paths, options);
    return header ? "no error" : tree.relative(to_string(header.diagnostics().front()));
  }
  int run(const std::vector<std::string>& paths, const std::string& program) const {
    const auto header = cpp_header(paths, options);
    if (!header) return -2;
    tree.file("modules.h", header->text);
    return run_program(tree, "#include \"modules.h\"\n" + program);
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Cpp, HostFunctionsAreTheDerivedClasss) {
  const std::string a =
      tree.file("a.glsl",
                "#ifndef A\n#define A\n#define LIMIT 3\nconst float k = 2.0f; // a constant\n"
                "float host(ivec2 at, // two\n           int q);\nfloat later(float x);\n"
                "struct Pair { float a; float b; };\n"
                "Pair twice(ivec2 at) {\n  Pair p;\n  p.a = host(at, LIMIT) * k; p.b = later(p.a);\n"
                "  return p;\n}\nfloat later(float x) { for (int i = 0; i < LIMIT; ++i) x += 1.0f; return x; "
                "}\n#endif\n");
  const std::string b = tree.file(
      "b.glsl", "#include \"a.glsl\"\nfloat sum(ivec2 at) { Pair p = twice(at); return p.a + p.b; }\n");
  EXPECT_EQ(
      run({b, a},
          "struct Host : gnomon::Modules {\n  float scale = 1;\n"
          "  float host(glm::ivec2 at, int q) const override { return scale * float(at.x + at.y + q); }\n};\n"
          "int main() {\n  Host one, two;\n  two.scale = 2;\n  const Host& host = two;\n"
          "  return one.sum({1, 2}) == 12 + 15 && host.sum({1, 2}) == 24 + 27 ? 0 : 1;\n}\n"),
      0);
}

TEST_F(Cpp, AnOptionalHostFunctionNeedsNoDefinitionUntilItIsAskedFor) {
  const std::string m =
      tree.file("m.glsl",
                "#define GNOMON_OPTIONAL\nGNOMON_OPTIONAL vec2 wanted(ivec2 at);\nfloat other(int q);\n"
                "float uses() { return wanted(ivec2(1, 2)).y; }\nfloat does_not() { return other(1); }\n");
  const std::string host =
      "#include <cstdlib>\nstruct Host : gnomon::Modules { float other(int) const override { return 4; } "
      "};\n";
  EXPECT_EQ(run({m}, host + "int main() { return Host().does_not() == 4 ? 0 : 1; }\n"), 0);
  EXPECT_EQ(run({m}, host + "struct Full : Host { glm::vec2 wanted(glm::ivec2 at) const override { "
                            "return glm::vec2(at); } };\n"
                            "int main() { return Full().uses() == 2 ? 0 : 1; }\n"),
            0);
  EXPECT_EQ(run({m}, host + "int main() { std::set_terminate([] { std::_Exit(7); }); Host().uses(); }\n"), 7);
}

TEST_F(Cpp, LinesLeadToTheModules) {
  tree.file("library/core/x.glsl", "#ifndef X\n#define X\n\nfloat x() { return 1.0f; }\n#endif\n");
  const std::string m = tree.file("m.glsl", "#include <gnomon/core/x.glsl>\nfloat m() { return x(); }\n");
  const auto header = cpp_header({m}, options);
  ASSERT_TRUE(header);
  EXPECT_NE(header->text.find("#line 1 \"gnomon/core/x.glsl\"\n#ifndef X\n"), std::string::npos)
      << header->text;
  EXPECT_NE(header->text.find("#line 2 \"m.glsl\"\nfloat m() const { return x(); }\n"), std::string::npos)
      << header->text;
}

TEST_F(Cpp, ModulesAreCheckedFirst) {
  EXPECT_EQ(error_of({tree.file("a.glsl", "float f() { return y; }\n")}),
            "a.glsl:1: error: 'y': undeclared identifier");
  EXPECT_EQ(error_of({tree.file("a.frag", "void main() {}\n")}),
            "a.frag: error: has a main(): it is a shader, not a module");
  EXPECT_EQ(error_of({tree.path("none.glsl")}),
            "none.glsl: error: cannot read the file: check the path and its permissions");
}

TEST_F(Cpp, OverloadsAreToldApartAndDefinesHold) {
  options.defines = {{"N", "8"}};
  EXPECT_EQ(
      run({tree.file(
              "a.glsl",
              "#ifndef N\n#define N 2\n#endif\nfloat host(ivec2 at, int q);\nfloat host(ivec2 i, int j);\n"
              "float host(ivec2 at) { return host(at, N); }\nfloat sq(int i);\n"
              "float sq(float x) { return sq(int(x)); }\nfloat sq(int i) { return float(i * i); }\n")},
          "struct Host : gnomon::Modules {\n"
          "  using Modules::host;\n  float host(glm::ivec2 at, int q) const override { return float(at.x + "
          "q); }\n};\n"
          "int main() { return Host().host({1, 2}) == 9 && Host().sq(3.0f) == 9 ? 0 : 1; }\n"),
      0);
}

TEST_F(Cpp, WhatIsNotCppIsRefusedAtItsLine) {
  EXPECT_EQ(error_of({tree.file("a.glsl", "float f(\n  inout float x) { return x; }\n")}),
            "a.glsl:2: error: 'inout' is not C++: pass the value in and return the result");
  EXPECT_EQ(
      error_of({tree.file("a.glsl", "\nfloat state;\nfloat f() { return state; }\n")}),
      "a.glsl:2: error: a variable outside of functions is not C++ here: make it const, or a parameter");
  const std::string a = tree.file("a.glsl", "float f() { return 1.0f; }\n");
  const std::string b = tree.file("b.glsl", "float f() { return 2.0f; }\n");
  EXPECT_TRUE(error_of({a, b}).starts_with("b.glsl:1: error: 'f'")) << error_of({a, b});
}

TEST_F(Cpp, WhatWouldMeanSomethingElseIsRefused) {
  const auto error = [&](const std::string& text) { return error_of({tree.file("a.glsl", text)}); };
  const std::string variable =
      "a.glsl:1: error: a variable outside of functions is not C++ here: make it const, or a parameter";
  EXPECT_EQ(error("struct S { float a; } s;\nfloat f() { return s.a; }\n"), variable);
  EXPECT_EQ(error("float f() {\n  return 1.5f + 2.5; }\n"),
            "a.glsl:2: error: '2.5' is a double in C++: write an f behind it");
  for (const std::string number : {"1e3", "1e-3", ".5", "1.", "1.5e+3"})
    EXPECT_TRUE(error("#define K " + number + "\nfloat f() { return K; }\n").find("double") !=
                std::string::npos)
        << number;
  for (const std::string number : {"1e3f", "1e-3f", ".5f", "1.f", "1.5e+3F", "float(0x1E)", "float(7)"})
    EXPECT_EQ(error("#if 10 > 2\n#define K " + number + " // 1.5\n#endif\nfloat f() { return K; }\n"),
              "no error")
        << number;
  EXPECT_EQ(error("float f() {\n  float a[2] = float[](1.0f, 2.0f);\n  return a[1]; }\n"),
            "a.glsl:2: error: array constructors are not C++: assign the elements one by one");
  EXPECT_EQ(error("#define F(n) float n() { return 1.0f; }\nF(f)\nfloat g() { return f(); }\n"),
            "a.glsl:2: error: 'F(': what a macro declares cannot be made a member of a C++ class: write the "
            "declaration out");
}

TEST_F(Cpp, PrecisionsAreLeftOut) {
  EXPECT_EQ(run({tree.file("a.glsl",
                           "struct S { highp float a; };\nhighp float f(mediump float highp_x) {\n"
                           "  lowp float y = highp_x;\n  return y;\n}\n")},
                "int main() { return gnomon::Modules().f(3.0f) == 3 ? 0 : 1; }\n"),
            0);
}

TEST_F(Cpp, ADefinitionThatIsNotInForceLeavesThePrototype) {
  EXPECT_EQ(run({tree.file("a.glsl",
                           "#ifdef NEVER\nfloat h(int i) { return 1.0f; }\n#endif\nfloat h(int i);\n"
                           "float none(void);\nfloat none() { return 1.0f; }\n"
                           "float g() { return h(1) + none(); }\n")},
                "struct Host : gnomon::Modules { float h(int i) const override { return float(i) + 1; } };\n"
                "int main() { return Host().g() == 3 ? 0 : 1; }\n"),
            0);
}

TEST_F(Cpp, FilesThatAreCalledAlikeAreToldApart) {
  const auto header = cpp_header({tree.file("d1/u.glsl", "float f() { return 1.0f; }\n"),
                                  tree.file("d2/u.glsl", "float g() { return 1.0f; }\n")},
                                 options);
  ASSERT_TRUE(header);
  for (const char* line : {"#line 1 \"d1/u.glsl\"\n", "#line 1 \"d2/u.glsl\"\n"})
    EXPECT_NE(header->text.find(line), std::string::npos) << header->text;
}

TEST_F(Cpp, TwoHeadersMeetUnderNamesOfTheirOwn) {
  const std::string a = tree.file("a.glsl", "#ifndef A\n#define A\nfloat f() { return 1.0f; }\n#endif\n");
  options.name = "Mine";
  tree.file("mine.h", cpp_header({a}, options)->text);
  options.name.clear();
  EXPECT_EQ(run({tree.file("b.glsl", "float f() { return 2.0f; }\n")},
                "#include \"mine.h\"\n#include \"mine.h\"\n"
                "int main() { return gnomon::Mine().f() == 1 && gnomon::Modules().f() == 2 ? 0 : 1; }\n"),
            0);
}

TEST_F(Cpp, TheLibraryWithAHostOfTwoLines) {
  options.library_directory = GNOMON_SOURCE_SHADERLIB;
  EXPECT_EQ(
      run({options.library_directory + "/relief/multilevel.glsl",
           options.library_directory + "/baseline/brute_force.glsl"},
          "struct Wall final : gnomon::Modules {\n"
          "  float gnomon_host_height(glm::ivec2 at, int) const override { return at.x == 20 ? 10.0f : 0.0f; "
          "}\n"
          "  float gnomon_host_extrema(glm::ivec2, int, int) const override { return 10.0f; }\n};\n"
          "int main() {\n  const Wall wall;\n  const Wall::GnomonMap map{{32, 8}, {32, 8}, {1, 1}, 10.0f, "
          "3};\n"
          "  const glm::vec3 sun = glm::normalize(glm::vec3(1, 0, 1));\n"
          "  for (int column = 0; column < 32; ++column) {\n"
          "    const auto here = wall.gnomon_receiver_at(float(column) + 0.5f, 4.5f, 0);\n"
          "    const float shadow = column > 10 && column < 20 ? 1.0f : 0.0f;  // 10 m high, 45 degrees\n"
          "    if (wall.gnomon_multilevel(map, here, sun, 0, 320).shadow != shadow) return 1;\n"
          "    if (wall.gnomon_brute_force(map, here, sun, 0, 320).shadow != shadow) return 2;\n  }\n}\n"),
      0);
}

}  // namespace
}  // namespace gnomon::compiler
