// SPDX-License-Identifier: MIT
// What the text of a target says otherwise than the source.
#include <algorithm>
#include <cstdint>
#include <cstring>
#include <vector>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Dialect : public testing::Test {
 protected:
  // The second line of `source` in the target's text; the first is the version.
  std::string line_for(const std::string& target, const std::string& name, const std::string& source) {
    options.target = target;
    const auto built = build(tree.file(name, source), options);
    if (!built) return to_string(built.diagnostics().front());
    std::string text = built->output;
    text.erase(0, text.find('\n') + 1);
    if (text.starts_with("precision")) text.erase(0, text.find('\n') + 1);
    return text.substr(0, text.find('\n'));
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Dialect, BindingsAndLocationsGoWhereTheTargetBindsByName) {
  const std::string sampler =
      "layout(binding = 3) uniform sampler2D a; out vec4 o; void main() { o = texture(a, vec2(0)); }";
  EXPECT_EQ(line_for("glsl450", "a.frag", sampler), sampler);
  EXPECT_EQ(line_for("essl310", "a.frag", sampler), sampler);
  const std::string bare =
      "                    uniform sampler2D a; out vec4 o; void main() { o = texture(a, vec2(0)); }";
  EXPECT_EQ(line_for("glsl330", "a.frag", sampler), bare);
  EXPECT_EQ(line_for("essl300", "a.frag", sampler), bare);
}

TEST_F(Dialect, LocationsStayAtTheEndsOfThePipeline) {
  EXPECT_EQ(
      line_for("glsl330", "a.vert",
               "layout(location = 1) in vec4 a; layout(location = 0) out vec4 b; void main() { b = a; }"),
      "layout(location = 1) in vec4 a;                      out vec4 b; void main() { b = a; }");
  EXPECT_EQ(
      line_for("essl300", "a.frag",
               "layout(location = 1) in vec4 a; layout(location = 0) out vec4 b; void main() { b = a; }"),
      "                     in vec4 a; layout(location = 0) out vec4 b; void main() { b = a; }");
  EXPECT_EQ(
      line_for("glsl330", "b.frag", "in layout(location = 1) vec4 a; out vec4 b; void main() { b = a; }"),
      "in                      vec4 a; out vec4 b; void main() { b = a; }");
}

TEST_F(Dialect, OtherQualifiersStay) {
  const std::string rest = " uniform B { vec4 a; }; out vec4 o; void main() { o = a; }";
  EXPECT_EQ(line_for("glsl330", "a.frag", "layout(binding = (1), std140)" + rest),
            "layout(               std140)" + rest);
  EXPECT_EQ(line_for("glsl330", "a.frag", "layout(std140, binding = 1)" + rest),
            "layout(std140             )" + rest);
  EXPECT_EQ(line_for("glsl330", "a.frag", "layout(set=0,std140,binding=1,row_major)" + rest),
            "layout(      std140,          row_major)" + rest);
  EXPECT_EQ(line_for("glsl450", "a.frag", "layout(set = 0, std140)" + rest),
            "layout(         std140)" + rest);
}

TEST_F(Dialect, CommentsAndOtherWordsStay) {
  const std::string line =
      "/* layout(binding = 1) */ out vec4 my_layout; void main() { my_layout = vec4(1.0); } // layout(set = "
      "1)";
  EXPECT_EQ(line_for("glsl330", "a.frag", line), line);
}

TEST_F(Dialect, EsslHasHighPrecisionAfterExtensionsAndOutsideOfConditionals) {
  options.target = "essl300";
  const auto built = build(
      tree.file("a.frag",
                "#ifdef GL_EXT_nothing\n#extension GL_EXT_nothing : enable\n#endif\n"
                "#ifdef NEVER\nfloat never;\n#endif\n"
                "uniform sampler2DArray a;\nout vec4 o;\nvoid main() {\n  o = texture(a, vec3(0));\n}\n"),
      options);
  ASSERT_TRUE(built) << to_string(built.diagnostics().front());
  const std::string& text = built->output;
  EXPECT_LT(text.find("#endif"), text.find("precision highp float;"));
  EXPECT_LT(text.rfind("precision highp sampler2DArray;"), text.find("uniform sampler2DArray a;"));
  EXPECT_GT(text.rfind("precision highp sampler2DArray;"), text.find("float never;"));
}

TEST_F(Dialect, ExtensionsOfOtherDialectsDoNoHarm) {
  options.target = "essl300";
  for (const char* source :
       {"#ifndef GL_ES\n#extension GL_ARB_x : enable\nvec4 desktop() { return vec4(1); }\n#endif\n",
        "#if defined(GL_ES) && defined(GL_EXT_x)\n#extension GL_EXT_x : enable\nfloat f(float a) { return a; "
        "}\n"
        "#else\nfloat f(float a) { return a; }\n#endif\n",
        "float f(float a) { return a; }\n#extension GL_EXT_x : enable\n"}) {
    const auto built = build(
        tree.file("a.frag", std::string(source) + "out vec4 o;\nvoid main() { o = vec4(1); }\n"), options);
    EXPECT_TRUE(built) << to_string(built.diagnostics().front());
  }
}

TEST_F(Dialect, AMacrosLayoutStaysWithoutAStorageOfItsOwn) {
  options.target = "glsl330";
  const auto built = build(tree.file("a.vert",
                                     "#define LOC(n) layout(location = n)\nout vec3 v;\nLOC(1) in vec3 a;\n"
                                     "void main() { v = a; gl_Position = vec4(a, 1); }\n"),
                           options);
  ASSERT_TRUE(built) << to_string(built.diagnostics().front());
  EXPECT_EQ(built->reflection.inputs.at(0).location, 1);
}

TEST_F(Dialect, AnErrorBehindThePrecisionsIsAtItsOwnLine) {
  options.target = "essl300";
  const auto built =
      build(tree.file("a.frag", "#extension GL_EXT_nothing : enable\nvoid main() {\n  x = 1;\n}\n"), options);
  ASSERT_FALSE(built);
  EXPECT_EQ(tree.relative(to_string(built.diagnostics().front())),
            "a.frag:3: error: 'x': undeclared identifier");
}

TEST_F(Dialect, PrecisionsComeBeforeCodeWithAnExtensionBehindIt) {
  options.target = "essl300";
  const std::string path =
      tree.file("a.frag", "float a;\n#extension GL_EXT_nothing : enable\nvoid main() {\n  x = 1;\n}\n");
  const auto built = build(path, options);
  ASSERT_FALSE(built);
  EXPECT_EQ(tree.relative(to_string(built.diagnostics().front())),
            "a.frag:4: error: 'x': undeclared identifier");
}

// What glslang makes of the functions of a text for Vulkan, whose SPIR-V names them.
size_t relaxed_decorations(const std::string& spirv) {
  constexpr std::uint32_t kDecorate = 71;
  constexpr std::uint32_t kRelaxedPrecision = 0;
  std::vector<std::uint32_t> words(spirv.size() / 4);
  std::memcpy(words.data(), spirv.data(), words.size() * 4);
  size_t count = 0;
  for (size_t at = 5; at < words.size(); at += std::max(words[at] >> 16, 1u))
    count += (words[at] & 0xFFFF) == kDecorate && words[at + 2] == kRelaxedPrecision ? 1 : 0;
  return count;
}

TEST_F(Dialect, PrecisionOfTheUserLeavesTheLibraryHighp) {
  tree.file("library/m.glsl",
            "#ifndef M\n#define M\nfloat gnomon_host_height(ivec2 at, int q);\n"
            "float m(float x) { return x * 2.0 + gnomon_host_height(ivec2(x), 0); }\n#endif\n");
  const std::string host = "float gnomon_host_height(ivec2 at, int q) {\n  return float(at.x * q);\n}\n";
  const std::string own = "float own(float x) { return x * 3.0; }\n";
  const std::string end =
      "layout(location = 0) in float i;\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = vec4(m(i) + own(i)); }\n";
  const std::string precise = tree.file("a.frag", "#include <gnomon/m.glsl>\n" + host + own + end);
  const std::string given = "precision mediump float;\nprecision mediump int;\n";
  const std::string mixed = tree.file("b.frag", given + "#include <gnomon/m.glsl>\n" + host + own + end);
  const std::string alone = tree.file("c.frag", given + "float m(float x) { return x; }\n" + own + end);
  for (const std::string target : {"essl300", "essl310", "vulkan", "opengl"}) {
    options.target = target;
    for (const std::string& path : {precise, mixed}) {
      const auto built = build(path, options);
      EXPECT_TRUE(built) << target << ": " << to_string(built.diagnostics().front());
    }
  }
  options.target = "vulkan";
  EXPECT_EQ(relaxed_decorations(build(precise, options)->output), 0u);
  const auto relaxed = build(mixed, options);
  EXPECT_GT(relaxed_decorations(relaxed->output), 0u) << "the user's own stays as stated";
  // Of the text: what the library and the host have stands between highp and the user's own.
  const std::string& text = relaxed->source.text;
  const auto last_before = [&](std::string_view word) {
    const size_t at = text.rfind("precision ", text.find(word));
    return text.substr(at, text.find(';', at) - at);
  };
  for (const std::string word : {"float m(float x)", "return float(at.x"})
    EXPECT_NE(last_before(word).find("highp"), std::string::npos) << text;
  for (const std::string word : {"float own(", "in float i;"})
    EXPECT_NE(last_before(word).find("GNOMON_PRECISION_"), std::string::npos) << text;
}

TEST_F(Dialect, PrecisionOfTheUserHoldsByItsConditional) {
  tree.file("library/m.glsl", "float m(float x) { return x * 2.0; }\n");
  const std::string source =
      "#ifdef LOW\nprecision mediump float;\n#endif\n#include <gnomon/m.glsl>\n"
      "layout(location = 0) in float i;\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = vec4(m(i) * 3.0); }\n";
  const std::string path = tree.file("a.frag", source);
  options.target = "vulkan";
  EXPECT_EQ(relaxed_decorations(build(path, options)->output), 0u);
  options.defines = {{"LOW", "1"}};
  EXPECT_GT(relaxed_decorations(build(path, options)->output), 0u);
}

TEST_F(Dialect, ErrorsKeepTheirLinesAmongPrecisions) {
  tree.file("library/m.glsl", "float m(float x) { return x * 2.0; }\n");
  options.target = "essl300";
  const auto built = build(tree.file("a.frag",
                                     "precision mediump float;\n#include <gnomon/m.glsl>\n\n"
                                     "float f() { return y; }\nvoid main() {}\n"),
                           options);
  ASSERT_FALSE(built);
  EXPECT_EQ(tree.relative(to_string(built.diagnostics().front())),
            "a.frag:4: error: 'y': undeclared identifier");
}

TEST_F(Dialect, ACommentBehindAnExtensionMayGoOn) {
  options.target = "essl300";
  const auto built = build(tree.file("a.frag",
                                     "// first\n#extension GL_EXT_YUV_target : enable /* a comment that\n"
                                     "goes on */\nout vec4 o;\nvoid main() { o = vec4(1); }\n"),
                           options);
  EXPECT_TRUE(built) << to_string(built.diagnostics().front());
}

TEST_F(Dialect, IncludesAreKnownForEveryTarget) {
  tree.file("b.glsl", "float b() { return 1.0; }\n");
  const std::string path =
      tree.file("a.frag", "#include \"b.glsl\"\nout vec4 o;\nvoid main() { o = vec4(b()); }\n");
  for (const std::string target : {"glsl450", "essl300"}) {
    options.target = target;
    EXPECT_EQ(build(path, options)->source.includes.size(), 1u) << target;
  }
}

}  // namespace
}  // namespace gnomon::compiler
