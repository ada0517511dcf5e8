// SPDX-License-Identifier: MIT
// Numbers that the source leaves open lie around those that it gives.
#include <map>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

using Numbers = std::map<std::string, int>;

class Numbering : public testing::Test {
 protected:
  Reflection reflect(const std::string& target, const std::string& name, const std::string& source) {
    options.target = target;
    auto built = build(tree.file(name, source), options);
    if (built) return built->reflection;
    ADD_FAILURE() << target << ": " << to_string(built.diagnostics().front());
    return {};
  }
  std::string error(const std::string& target, const std::string& name, const std::string& source) {
    options.target = target;
    const auto built = build(tree.file(name, source), options);
    return built ? "no error" : tree.relative(to_string(built.diagnostics().front()));
  }
  static Numbers locations(const std::vector<Variable>& variables) {
    Numbers numbers;
    for (const Variable& v : variables) numbers[v.name] = v.location.value_or(-1);
    return numbers;
  }
  static Numbers bindings(const Reflection& reflection) {
    Numbers numbers;
    for (const Variable& v : reflection.textures) numbers[v.name] = v.binding.value_or(-1);
    for (const Block& block : reflection.blocks) numbers[block.name] = block.binding.value_or(-1);
    return numbers;
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Numbering, VertexInputs) {
  const std::string source =
      "layout(location = 0) in vec4 position; in vec2 uv; in mat4 m; layout(location = 3) in vec3 n;\n"
      "in vec4 a[2]; in vec4 late;\nvoid main() { gl_Position = m * position + a[1] + late + vec4(n, "
      "uv.x); }\n";
  for (const char* target : {"opengl", "vulkan", "hlsl50", "msl21"})
    EXPECT_EQ(locations(reflect(target, "a.vert", source).inputs),
              (Numbers{{"position", 0}, {"uv", 1}, {"late", 2}, {"n", 3}, {"m", 4}, {"a", 8}}))
        << target;
}

TEST_F(Numbering, FragmentOutputs) {
  const std::string source =
      "layout(location = 1) out vec4 a; out vec4 b; out vec4 c[2]; out vec4 d;\n"
      "void main() { a = b = c[0] = c[1] = d = vec4(1.0); }\n";
  for (const char* target : {"opengl", "vulkan", "hlsl50", "msl21"})
    EXPECT_EQ(locations(reflect(target, "a.frag", source).outputs),
              (Numbers{{"b", 0}, {"a", 1}, {"c", 2}, {"d", 4}}))
        << target;
}

TEST_F(Numbering, UniformsOfOpenGlsSpirv) {
  const Reflection r = reflect(
      "opengl", "a.frag",
      "struct S { float a[2][3]; float b; };\n"
      "layout(location = 1) uniform vec4 a[4]; uniform mat4 m[3]; uniform float f; layout(location = "
      "30) uniform S s;\n"
      "layout(location = 40, binding = 1) uniform sampler2D t; uniform dvec4 d; uniform vec4 unused;\n"
      "layout(location = 0) out vec4 o;\n"
      "void main() { o = a[1] * m[2] * f * s.a[1][2] * s.b * texture(t, vec2(0)) * vec4(d); }\n");
  EXPECT_EQ(locations(r.uniforms),
            (Numbers{{"f", 0}, {"a", 1}, {"m", 5}, {"d", 8}, {"s.a", 30}, {"s.b", 36}}));
  EXPECT_EQ(r.textures.at(0).location, std::nullopt);
  const Variable& array =
      *std::find_if(r.uniforms.begin(), r.uniforms.end(), [](const Variable& v) { return v.name == "s.a"; });
  EXPECT_EQ(array.type, "float");
  EXPECT_EQ(array.array_size, 6);
}

// Those of plain variables glslang sees itself.
TEST_F(Numbering, LocationsThatOverlapAreToldWithBothLines) {
  const std::string source =
      "struct S { float a[6]; float c; };\nfloat f(float b) { return b; }\n"
      "layout(location = 0) uniform S s;\nlayout(location = 6) uniform float b;\n"
      "layout(location = 0) out vec4 o;\nvoid main() { o = vec4(s.c * f(b)); }\n";
  for (const char* target : {"opengl", "glsl450"}) {
    options.target = target;
    const auto built = build(tree.file("a.frag", source), options);
    ASSERT_FALSE(built) << target;
    const std::string told = tree.relative(to_string(built.diagnostics().front()));
    EXPECT_EQ(
        told.substr(0, told.find(';')),
        "a.frag:4: error: 'b': its location 6 is also that of 's', which takes 0 to 6: give it another");
    EXPECT_EQ(tree.relative(built.diagnostics().front().notes.at(0)), "the other one: a.frag:3");
  }
  EXPECT_EQ(error("glsl330", "a.frag", source), "no error");  // by name
}

TEST_F(Numbering, UniformsUseUpNoBindings) {
  const Reflection r = reflect(
      "opengl", "a.frag",
      "uniform vec4 u[200]; uniform sampler2D t; uniform sampler2D ts[2][3]; uniform sampler2D last;\n"
      "layout(std140) uniform B { vec4 x; };\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = u[3] + x + texture(t, vec2(0)) + texture(ts[1][2], vec2(0)) + texture(last, "
      "vec2(0)); }\n");
  EXPECT_EQ(bindings(r), (Numbers{{"t", 0}, {"ts", 1}, {"last", 7}, {"B", 0}}));
}

TEST_F(Numbering, ArraysTakeANumberForEachElement) {
  const std::string source =
      "uniform sampler2D t[2]; uniform sampler2D z; layout(binding = 3) uniform sampler2D given;\n"
      "uniform sampler2D late[2];\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = texture(t[1], vec2(0)) + texture(z, vec2(0)) + texture(given, vec2(0)) + "
      "texture(late[0], vec2(0)); }\n";
  for (const char* target : {"opengl", "hlsl50", "msl21"})
    EXPECT_EQ(bindings(reflect(target, "a.frag", source)),
              (Numbers{{"t", 0}, {"z", 2}, {"given", 3}, {"late", 4}}))
        << target;
  EXPECT_EQ(bindings(reflect("vulkan", "a.frag", source)),
            (Numbers{{"t", 0}, {"z", 1}, {"given", 3}, {"late", 2}}));
}

TEST_F(Numbering, ATextureOfHlslHasASamplersNumberToo) {
  const std::string shared =
      "layout(binding = 0) uniform sampler2D t; layout(binding = 1) uniform texture2D u;\n"
      "layout(binding = 0) uniform sampler s;\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = texture(t, vec2(0)) + texture(sampler2D(u, s), vec2(0)); }\n";
  EXPECT_TRUE(
      error("hlsl50", "a.frag", shared)
          .starts_with("a.frag:2: error: 's', a sampler: its place for the target hlsl50, register s0"))
      << error("hlsl50", "a.frag", shared);
}

// Direct3D 11 counts what a fragment shader writes behind its render targets.
TEST_F(Numbering, BuffersThatAFragmentShaderWritesComeAfterItsOutputs) {
  const std::string source =
      "layout(std430) buffer A { float x; };\nlayout(location = 0) out vec4 o; layout(location = 1) out vec4 "
      "p;\n"
      "void main() { x = 1.0; o = p = vec4(1.0); }\n";
  EXPECT_EQ(reflect("hlsl50", "a.frag", source).blocks.at(0).binding, 2);
  const std::string given =
      "\nlayout(std430, binding = 1) buffer A { float x; };\nlayout(location = 0) out vec4 o;\n"
      "layout(location = 1) out vec4 p;\nvoid main() { x = 1.0; o = p = vec4(1.0); }\n";
  EXPECT_TRUE(
      error("hlsl50", "a.frag", given)
          .starts_with("a.frag:2: error: 'A', a storage block: its place for the target hlsl50, register u1, "
                       "is also that of the output SV_Target1: give it a binding from 2 upwards"))
      << error("hlsl50", "a.frag", given);
}

TEST_F(Numbering, BeyondWhatALanguageHas) {
  const auto texture = [](int binding) {
    return "layout(binding = " + std::to_string(binding) +
           ") uniform sampler2D t;\nlayout(location = 0) out vec4 o;\nvoid main() { o = texture(t, vec2(0)); "
           "}\n";
  };
  for (const char* target : {"hlsl50", "msl21"}) {
    EXPECT_EQ(error(target, "a.frag", texture(15)), "no error");
    EXPECT_TRUE(error(target, "a.frag", texture(16)).starts_with("a.frag:1: error: 't', a texture:"))
        << target;
  }
  const std::string block =
      "layout(std140, binding = 14) uniform B { vec4 x; };\nlayout(location = 0) out vec4 o;\nvoid main() { "
      "o = x; }\n";
  EXPECT_TRUE(
      error("hlsl50", "a.frag", block)
          .starts_with("a.frag:1: error: 'B', a uniform block: its place for the target hlsl50, register "
                       "b14, is beyond the last one, register b13"));
  EXPECT_EQ(error("msl21", "a.frag", block), "no error");
}

TEST_F(Numbering, PushConstantsAndInputAttachmentsAreReflectedAndDoNotClash) {
  const std::string source =
      "layout(push_constant) uniform Push { vec4 p; } push;\nlayout(std140) uniform B { vec4 x; };\n"
      "layout(input_attachment_index = 1) uniform subpassInput s; uniform sampler2D t;\n"
      "layout(location = 0) out vec4 o;\nvoid main() { o = push.p + x + subpassLoad(s) + texture(t, "
      "vec2(0)); }\n";
  for (const char* target : {"hlsl50", "msl21"})
    EXPECT_EQ(bindings(reflect(target, "a.frag", source)),
              (Numbers{{"Push", 0}, {"B", 1}, {"s", 0}, {"t", 1}}))
        << target;
  options.target = "msl21";
  const std::string msl = build(tree.path("a.frag"), options)->output;
  EXPECT_NE(msl.find("push [[buffer(0)]]"), std::string::npos) << msl;
  EXPECT_NE(msl.find("s [[texture(0)]]"), std::string::npos) << msl;
  options.target = "hlsl50";
  const std::string hlsl = build(tree.path("a.frag"), options)->output;
  EXPECT_NE(hlsl.find("push : register(b0)"), std::string::npos) << hlsl;
}

TEST_F(Numbering, WhatMainDoesNotReachTakesNoPlaceInATranslation) {
  const std::string source =
      "uniform sampler2D unused; uniform sampler2D t;\nlayout(location = 0) in vec4 passed;\n"
      "layout(location = 0) out vec4 o;\nvoid main() { o = texture(t, vec2(0)); }\n";
  for (const char* target : {"hlsl50", "msl21"}) {
    options.target = target;
    const auto built = build(tree.file("a.frag", source), options);
    ASSERT_TRUE(built);
    EXPECT_EQ(built->reflection.textures.at(0).binding, 0);
    EXPECT_EQ(built->output.find("unused"), std::string::npos) << built->output;
    // HLSL matches the two sides by the order too, Metal by the location alone.
    const bool is_there = built->output.find("passed") != std::string::npos;
    EXPECT_EQ(is_there, std::string(target) == "hlsl50") << built->output;
  }
}

TEST_F(Numbering, ABlockOfTheNameThatIsGivenToUniformsKeepsIt) {
  const Reflection r = reflect("vulkan", "a.frag",
                               "layout(std140) uniform gnomon_uniforms { vec4 mine; }; uniform float loose;\n"
                               "layout(location = 0) out vec4 o;\nvoid main() { o = mine * loose; }\n");
  EXPECT_EQ(bindings(r), (Numbers{{"gnomon_uniforms", 0}, {"gnomon_uniforms2", 1}}));
}

}  // namespace
}  // namespace gnomon::compiler
