// SPDX-License-Identifier: MIT
// What each target makes of a shader, and what it refuses.
#include <cstring>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Targets : public testing::Test {
 protected:
  Result<Compiled> made(const std::string& target, const std::string& name, const std::string& source) {
    options.target = target;
    return build(tree.file(name, source), options);
  }
  std::string error(const std::string& target, const std::string& name, const std::string& source) {
    const auto built = made(target, name, source);
    return built ? "no error" : tree.relative(to_string(built.diagnostics().front()));
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

constexpr const char* kLoose =
    "uniform float a;\nuniform sampler2D b;\nlayout(location = 0) in vec2 c;\nout vec4 o;\n"
    "void main() {\n  o = (a + 0.1) - a + texture(b, c);\n}\n";

TEST_F(Targets, EachMakesItsOwnFormat) {
  for (const char* name : {"glsl450", "glsl330", "essl300", "essl310"}) {
    const auto built = made(name, "a.frag", kLoose);
    ASSERT_TRUE(built) << to_string(built.diagnostics().front());
    EXPECT_TRUE(built->output.starts_with(find_target(name)->version_line + "\n")) << built->output;
    EXPECT_FALSE(built->reflection.spirv_size.has_value());
  }
  for (const char* name : {"vulkan", "opengl"}) {
    const auto built = made(name, "a.frag", kLoose);
    ASSERT_TRUE(built) << to_string(built.diagnostics().front());
    std::uint32_t magic = 0;
    std::memcpy(&magic, built->output.data(), sizeof magic);
    EXPECT_EQ(magic, 0x07230203u);
    EXPECT_EQ(built->reflection.spirv_size, built->output.size());
  }
  EXPECT_NE(made("hlsl50", "a.frag", kLoose)->output.find("cbuffer gnomon_uniforms"), std::string::npos);
  EXPECT_NE(made("msl21", "a.frag", kLoose)->output.find("#include <metal_stdlib>"), std::string::npos);
}

// (a + 0.1) - a is 0.1 to an optimiser, and is not in floats.
TEST_F(Targets, SumsStayAsWritten) {
  for (const char* name : {"hlsl50", "msl21"})
    EXPECT_NE(made(name, "a.frag", kLoose)->output.find("a + 0.1"), std::string::npos) << name;
}

TEST_F(Targets, ComputeIsRefusedWhereThereIsNone) {
  const std::string source = "#version 450\n\nlayout(local_size_x = 8) in;\nvoid main() {}\n";
  EXPECT_EQ(error("essl300", "a.comp", source),
            "a.comp:3: error: compute shaders: the target essl300 has none; refused for the target essl300, "
            "taken by "
            "glsl450, essl310, vulkan, opengl, hlsl50 and msl21");
  EXPECT_EQ(error("essl310", "a.comp", source), "no error");
}

TEST_F(Targets, GatherIsRefusedWhereThereIsNone) {
  const std::string source =
      "uniform sampler2D a;\nout vec4 o;\nvoid main() {\n  o = textureGather(a, vec2(0.5));\n}\n";
  EXPECT_EQ(error("glsl330", "a.frag", source),
            "a.frag:4: error: 'textureGather(...)': not supported for this version or the enabled "
            "extensions; refused for the target "
            "glsl330, "
            "taken by glsl450, essl310, vulkan, opengl, hlsl50 and msl21");
}

// ESSL objects before, so nothing is known of what it would say of the gather.
TEST_F(Targets, OnlyTargetsThatWereSeenToTakeItAreNamed) {
  const std::string source =
      "uniform sampler2D a;\nlayout(location = 0) noperspective in vec2 b;\nout vec4 o;\nvoid main() {\n  o "
      "= textureGather(a, "
      "b);\n}\n";
  EXPECT_EQ(error("glsl330", "a.frag", source),
            "a.frag:5: error: 'textureGather(...)': not supported for this version or the enabled "
            "extensions; refused "
            "for the target glsl330, taken by glsl450, vulkan, opengl, hlsl50 and msl21");
}

TEST_F(Targets, VaryingsWithoutALocationAreRefusedWhereTheyAreNumbered) {
  const std::string source = "in vec2 a;\nout vec4 o;\nvoid main() {\n  o = vec4(a, a);\n}\n";
  EXPECT_EQ(error("opengl", "a.frag", source),
            "a.frag:1: error: 'a': passes between stages without a location, by which SPIR-V matches the two "
            "sides: "
            "write layout(location = N) in both; refused for the target opengl, taken by glsl450, glsl330, "
            "essl300 and "
            "essl310");
}

TEST_F(Targets, ResourcesThatOnlySetsTellApartAreRefusedWhereThereAreNone) {
  const std::string source =
      "layout(set = 0, binding = 0) uniform sampler2D a;\nlayout(set = 1, binding = 0) uniform sampler2D b;\n"
      "layout(location = 0) out vec4 o;\nvoid main() {\n  o = texture(a, vec2(0)) + texture(b, "
      "vec2(0));\n}\n";
  EXPECT_EQ(error("vulkan", "a.frag", source), "no error");
  EXPECT_EQ(
      error("hlsl50", "a.frag", source),
      "a.frag:2: error: 'b', a texture: its place for the target hlsl50, register t0, is also that of 'a', a "
      "texture: give it another binding; refused for the target hlsl50, taken by glsl330, essl300 and "
      "vulkan");
  for (const char* target : {"msl21", "opengl", "glsl450"})
    EXPECT_TRUE(error(target, "a.frag", source).starts_with("a.frag:2: error: 'b', a texture:")) << target;
}

TEST_F(Targets, KindsThatShareNumbersAreRefusedAtTheSameOne) {
  const std::string written =
      "layout(local_size_x = 8) in;\nlayout(std430, binding = 0) buffer M { vec4 l[]; } m;\n"
      "layout(binding = 0, rgba8) uniform writeonly highp image2D im;\n"
      "void main() { m.l[0] = vec4(1); imageStore(im, ivec2(0), m.l[0]); }\n";
  EXPECT_EQ(error("glsl450", "a.comp", written), "no error");
  EXPECT_TRUE(error("hlsl50", "a.comp", written)
                  .starts_with("a.comp:3: error: 'im', an image: its place for the "
                               "target hlsl50, register u0, is also that of 'M'"));
  EXPECT_TRUE(error("vulkan", "a.comp", written)
                  .starts_with("a.comp:3: error: 'im', an image: its place for the "
                               "target vulkan, set 0, binding 0, is also that of 'M'"));
  const std::string apart =
      "layout(std140, binding = 0) uniform B { vec4 x; }; layout(binding = 0) uniform sampler2D t;\n"
      "layout(location = 0) out vec4 o; void main() { o = x + texture(t, vec2(0)); }\n";
  for (const char* target : {"hlsl50", "msl21", "opengl"})
    EXPECT_EQ(error(target, "a.frag", apart), "no error") << target;
  EXPECT_NE(error("vulkan", "a.frag", apart), "no error");
}

TEST_F(Targets, BooleanUniformsAreRefusedAtTheirLineForOpenGlsSpirv) {
  const std::string source =
      "layout(location = 0) out vec4 o;\nuniform bool flag;\nvoid main() {\n  o = vec4(flag ? 1.0 : "
      "0.0);\n}\n";
  EXPECT_TRUE(error("opengl", "a.frag", source)
                  .starts_with("a.frag:2: error: 'flag': a uniform of type bool has no form"));
  for (const char* target : {"glsl450", "vulkan", "hlsl50", "msl21"})
    EXPECT_EQ(error(target, "a.frag", source), "no error");
}

TEST_F(Targets, MembersOfHlslsUniformsAreCalledAfterTheirBlock) {
  EXPECT_NE(made("hlsl50", "a.frag", kLoose)->output.find("float gnomon_uniforms_data_a "), std::string::npos)
      << made("hlsl50", "a.frag", kLoose)->output;
}

TEST_F(Targets, BindingsOfTheSourceAreThoseOfMsl) {
  const std::string msl =
      made("msl21", "a.frag",
           "layout(binding = 5) uniform sampler2D a; layout(std140, binding = 7) uniform B { vec4 x; };\n"
           "layout(location = 0) out vec4 o; void main() { o = texture(a, vec2(0)) + x; }\n")
          ->output;
  EXPECT_NE(msl.find("[[texture(5)]]"), std::string::npos) << msl;
  EXPECT_NE(msl.find("[[sampler(5)]]"), std::string::npos) << msl;
  EXPECT_NE(msl.find("[[buffer(7)]]"), std::string::npos) << msl;
}

TEST_F(Targets, GeometryShadersAreRefusedWhereThereAreNone) {
  const std::string source =
      "layout(points) in;\nlayout(points, max_vertices = 1) out;\nvoid main() {\n  gl_Position = "
      "vec4(0.0);\n  "
      "EmitVertex();\n}\n";
  EXPECT_EQ(
      error("msl21", "a.geom", source),
      "a.geom:2: error: geometry shaders: the target msl21 has none; refused for the target msl21, taken by "
      "glsl450, glsl330, vulkan and opengl");
}

// glslang takes the word for a name, or for a reserved one, and says something about that.
TEST_F(Targets, AWordThatADialectDoesNotHaveIsToldAsThat) {
  struct Case {
    std::string declaration;
    std::vector<std::string> targets;
    std::string expected;
  };
  const std::vector<Case> cases = {
      {"layout(std430) buffer B { float x; };",
       {"glsl330", "essl300"},
       "'buffer': the target has no storage blocks"},
      {"buffer B { float x; };", {"glsl330", "essl300"}, "'buffer': the target has no storage blocks"},
      {"uniform texture2D x;",
       {"glsl450", "essl310", "opengl"},
       "'texture2D': the target has no textures apart from"},
      {"uniform samplerBuffer x;",
       {"essl300", "essl310"},
       "'samplerBuffer': the target has no texture buffers"},
      {"uniform double x;", {"glsl330", "essl300", "essl310"}, "'double': the target has no doubles"},
      {"layout(location = 0) noperspective in vec4 x;",
       {"essl300", "essl310"},
       "'noperspective': the target has no interpolation without"},
      {"uniform sampler1D x;", {"essl310"}, "'sampler1D': the target has no one-dimensional textures"}};
  for (const Case& c : cases) {
    for (const std::string& target : c.targets) {
      const std::string told =
          error(target, "a.frag",
                "// buffer\n" + c.declaration + "\nout vec4 o;\nvoid main() { o = vec4(1.0); }\n");
      EXPECT_EQ(told.substr(0, 17 + c.expected.size()), "a.frag:2: error: " + c.expected) << told;
      EXPECT_NE(told.find("; refused for the target " + target + ", taken by "), std::string::npos) << told;
    }
  }
}

TEST_F(Targets, AMistakeIsNoLackOfTheTarget) {
  for (const Target& target : targets())
    EXPECT_EQ(error(target.name, "a.frag", "void main() {\n  x = 1;\n}\n"),
              "a.frag:2: error: 'x': undeclared identifier");
}

TEST_F(Targets, ASecondWayIsTakenByItself) {
  const std::string source =
      "uniform sampler2D a;\nout vec4 o;\nvoid main() {\n#if __VERSION__ >= 400 || (defined(GL_ES) && "
      "__VERSION__ >= 310)\n"
      "  o = textureGather(a, vec2(0.5));\n#else\n  o = texture(a, vec2(0.5));\n#endif\n}\n";
  for (const Target& target : targets())
    EXPECT_EQ(error(target.name, "a.frag", source), "no error") << target.name;
}

}  // namespace
}  // namespace gnomon::compiler
