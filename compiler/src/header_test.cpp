// SPDX-License-Identifier: MIT
// The generated header, compiled and run by a C++ compiler.
#include "gnomon/compiler/compiler.h"
#include "temporary_program.h"

namespace gnomon::compiler {
namespace {

class Header : public testing::Test {
 protected:
  void make(const std::string& name, const std::string& source) {
    const auto built = build(tree.file(name, source), options);
    ASSERT_TRUE(built) << to_string(built.diagnostics().front());
    tree.file(name + ".h", built->output);
    text = built->output;
  }
  // The exit code of a program with these statements.
  int run(const std::string& includes, const std::string& statements) const {
    return run_program(tree, includes + "#include <cstring>\nint main() {\n" + statements + "\n}\n");
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library"), .target = "header"};
  std::string text;
};

TEST_F(Header, HoldsTextWordsAndReflection) {
  const std::string source =
      "// \"quotes\" \\ ?\?/ \u00e9\nuniform float a; uniform float mutable_; uniform sampler2D new_;\n"
      "layout(std140) uniform B { vec4 x; vec4 size; };\nout vec4 o;\n"
      "void main() { o = vec4(a * mutable_) + x + size + texture(new_, vec2(0)); }";
  options.embedded = {"glsl330", "vulkan"};
  make("a.frag", source);
  EXPECT_EQ(
      run("#include \"a.frag.h\"\n#include \"a.frag.h\"\n",
          "namespace s = gnomon_shaders::a_frag;\n"
          "static_assert(s::stage == \"fragment\");\n"
          "static_assert(s::vulkan::spirv[0] == 0x07230203u);\n"
          "static_assert(s::vulkan::blocks::gnomon_uniforms::size == 16);\n"
          "static_assert(s::vulkan::blocks::gnomon_uniforms::mutable_.offset == 4);\n"
          "static_assert(s::glsl330::blocks::B::size == 32 && s::glsl330::blocks::B::size_.offset == 16);\n"
          "static_assert(s::glsl330::uniforms::all.size() == 2 && s::glsl330::uniforms::a.location == -1);\n"
          "static_assert(s::glsl330::textures::new_.type == \"sampler2D\");\n"
          "const char* end = \"??\" \"/ \\303\\251\\n\";\n"
          "return s::glsl330::source.find(end) == s::glsl330::source.npos ? 3 : 0;"),
      0);
}

TEST_F(Header, LongTextsAreWhole) {
  std::string source;
  for (int i = 0; i < 4000; ++i) source += "// a line that is long enough\n";
  make("long.frag", source + "void main() {}\n// the end");
  EXPECT_EQ(
      run("#include \"long.frag.h\"\n",
          "const auto source = gnomon_shaders::long_frag::glsl450::source;\n"
          "return source.size() > 120000 && source.substr(source.size() - 11) == \"// the end\\n\" ? 0 : 3;"),
      0);
}

TEST_F(Header, TwoOfOneNameAreAnError) {
  options.name = "terrain";
  make("a.frag", "out vec4 o;\nvoid main() { o = vec4(1.0); }\n");
  make("b.frag", "out vec4 o;\nvoid main() { o = vec4(2.0); }\n");
  EXPECT_EQ(run("#include \"a.frag.h\"\n#include \"a.frag.h\"\n", "return 0;"), 0);
  EXPECT_EQ(run("#include \"a.frag.h\"\n#include \"b.frag.h\"\n", "return 0;"), -1);
}

TEST_F(Header, NamesThatAreMacrosElsewhere) {
  make("a.frag",
       "uniform float near; uniform float far; uniform float EOF; uniform float errno; uniform float NULL;\n"
       "uniform float assert; uniform float Variable;\nout vec4 o;\n"
       "void main() { o = vec4(near + far + EOF + errno + NULL + assert + Variable); }\n");
  EXPECT_EQ(run("#include <cassert>\n#include <cerrno>\n#include <cmath>\n#include <cstdio>\n#define "
                "near\n#define far\n"
                "#include \"a.frag.h\"\n",
                "return gnomon_shaders::a_frag::glsl450::uniforms::near_.name == \"near\" ? 0 : 3;"),
            0);
}

TEST_F(Header, EmbedsNoHeader) {
  options.embedded = {"header"};
  EXPECT_FALSE(build(tree.file("a.frag", "void main() {}"), options));
  options.embedded = {};
  EXPECT_FALSE(build(tree.file("a.frag", "void main() {}"), options));
}

}  // namespace
}  // namespace gnomon::compiler
