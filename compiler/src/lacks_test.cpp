// SPDX-License-Identifier: MIT
// What glslang takes and the languages behind it do not: refused by name, at its line.
#include <array>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

// In line 3 of a shader, or with a declaration in line 1.
struct Lack {
  std::string stage;
  std::string declaration;
  std::string statement;
  std::string target;
  std::string expected;  // the beginning of what is said
};

class Lacks : public testing::TestWithParam<Lack> {
 protected:
  std::string error(const std::string& target) {
    const Lack& lack = GetParam();
    options.target = target;
    std::string frame = "void main() {\n";
    if (lack.stage == "frag") frame = "layout(location = 0) out vec4 o; void main() {\n";
    if (lack.stage == "comp")
      frame = "layout(local_size_x = 8) in; layout(std430) buffer Out { vec4 o; }; void main() {\n";
    const std::string source = lack.declaration + "\n" + frame + lack.statement + "\n}\n";
    const auto built = build(tree.file("a." + lack.stage, source), options);
    return built ? "no error" : tree.relative(to_string(built.diagnostics().front()));
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_P(Lacks, IsToldByNameAndLine) {
  const std::string told = error(GetParam().target);
  EXPECT_EQ(told.substr(0, GetParam().expected.size()), GetParam().expected) << told;
  EXPECT_NE(told.find("; refused for the target " + GetParam().target + ", taken by "), std::string::npos)
      << told;
}

TEST_P(Lacks, IsTakenElsewhere) {
  EXPECT_EQ(error("glsl450"), "no error");
}

const std::string kGather =
    "o = textureGatherOffsets(t, vec2(0.5), ivec2[4](ivec2(0), ivec2(1), ivec2(2), ivec2(3)));";

INSTANTIATE_TEST_SUITE_P(
    Hlsl, Lacks,
    testing::Values(
        Lack{"vert", "", "gl_PointSize = 2.0;", "hlsl50", "a.vert:3: error: 'gl_PointSize': HLSL"},
        Lack{"frag", "", "o.xy = gl_PointCoord;", "hlsl50", "a.frag:3: error: 'gl_PointCoord': HLSL"},
        Lack{"comp", "", "o.x = float(gl_NumWorkGroups.x);", "hlsl50",
             "a.comp:3: error: 'gl_NumWorkGroups': HLSL for shader model 5.0 has none: pass it as a uniform"},
        Lack{"frag", "", "o.x = gl_HelperInvocation ? 1.0 : 0.0;", "hlsl50",
             "a.frag:3: error: 'gl_HelperInvocation': HLSL"},
        Lack{"frag", "uniform uint a;", "uint c; o.x = float(uaddCarry(a, 3u, c));", "hlsl50",
             "a.frag:3: error: 'uaddCarry': HLSL"},
        Lack{"frag", "uniform uint a;", "uint c, d; umulExtended(a, 3u, c, d); o.x = float(d);", "hlsl50",
             "a.frag:3: error: 'umulExtended': HLSL"},
        Lack{"frag", "uniform sampler2D t;", kGather, "hlsl50",
             "a.frag:3: error: 'textureGatherOffsets': HLSL"},
        Lack{"frag", "layout(rgba32f) uniform image2D t;", "o = imageLoad(t, ivec2(0));", "hlsl50",
             "a.frag:3: error: 't': HLSL for shader model 5.0 loads from an image that it may write only"},
        Lack{"frag", "layout(rgba8) uniform writeonly imageCube t;", "imageStore(t, ivec3(0), o);", "hlsl50",
             "a.frag:1: error: 't': HLSL for shader model 5.0 has no imageCube"},
        Lack{"frag", "layout(std140) uniform B { vec4 x; } b[3];", "o = b[1].x;", "hlsl50",
             "a.frag:1: error: 'B': HLSL for shader model 5.0 has no arrays of blocks"},
        Lack{"frag", "uniform sampler2D t[3]; uniform int i;", "o = texture(t[i], vec2(0));", "hlsl50",
             "a.frag:3: error: 't': HLSL for shader model 5.0 takes no index"},
        Lack{"frag", "uniform sampler2D t[2][3];", "o = texture(t[1][2], vec2(0));", "vulkan",
             "a.frag:1: error: 't': Vulkan's SPIR-V has no arrays of arrays of textures"},
        Lack{"frag", "struct S { sampler2D t; float x; }; uniform S s;", "o = texture(s.t, vec2(0)) * s.x;",
             "vulkan", "a.frag:1: error: 's': Vulkan's SPIR-V has no textures in structures"},
        // A name in an earlier line that is not the global one.
        Lack{"frag", "float f(float b) { return b; }\n uniform bool b;", "o.x = b ? f(1.0) : 0.0;", "opengl",
             "a.frag:2: error: 'b': a uniform of type bool has no form in OpenGL's SPIR-V"}));

INSTANTIATE_TEST_SUITE_P(
    Msl, Lacks,
    testing::Values(
        Lack{"frag", "uniform sampler2D t;", kGather, "msl21",
             "a.frag:3: error: 'textureGatherOffsets': MSL 2.1 has none"},
        Lack{"frag", "layout(location = 0) flat in int v;", "double d = double(v); o.x = float(d);", "msl21",
             "a.frag:3: error: 'double': MSL 2.1 has none: use float"},
        Lack{"frag", "layout(r32ui) uniform uimage2D t;", "o.x = float(imageAtomicAdd(t, ivec2(0), 1u));",
             "msl21", "a.frag:3: error: 'imageAtomicAdd': MSL 2.1 has none: use a storage buffer"},
        Lack{"frag", "", "o.x = float(gl_PrimitiveID);", "msl21", "a.frag:3: error: 'gl_PrimitiveID': MSL"},
        Lack{"vert", "out float gl_CullDistance[1];", "gl_CullDistance[0] = 1.0;", "msl21",
             "a.vert:3: error: 'gl_CullDistance': MSL"},
        Lack{"frag", "uniform sampler2D t;", "o.xy = textureQueryLod(t, vec2(0.5));", "msl21",
             "a.frag:3: error: 'textureQueryLod': MSL"},
        Lack{"frag", "layout(location = 0) in vec4 v;", "o = interpolateAtCentroid(v);", "msl21",
             "a.frag:3: error: 'interpolateAtCentroid': MSL"},
        Lack{"frag", "layout(std430) buffer L { float x[]; };", "o.x = float(x.length());", "msl21",
             "a.frag:3: error: 'length()': MSL"},
        Lack{"frag", "uniform sampler2DShadow t;", "o.x = texture(t, vec3(0), 1.0);", "msl21",
             "a.frag:3: error: 'texture': MSL 2.1 compares without a bias"},
        Lack{"frag", "layout(location = 0) in mat4 m[2];", "o = m[1][0];", "msl21",
             "a.frag:1: error: 'm': MSL 2.1 passes no arrays of matrices"},
        Lack{"frag", "uniform sampler1DShadow t;", "o.x = texture(t, vec3(0));", "msl21",
             "a.frag:1: error: 't': MSL 2.1 has no sampler1DShadow"}));

// By SPIRV-Cross itself, which says a name and no line.
INSTANTIATE_TEST_SUITE_P(
    Translator, Lacks,
    testing::Values(Lack{
        "frag",
        "float f(float inner) { return inner; } struct S { vec3 a[2]; float last; };\n"
        "layout(std140) uniform B {\nfloat before;\nS inner; };",
        "o = vec4(inner.last * f(before));", "hlsl50",
        "a.frag:4: error: 'inner', a member of the block 'B': HLSL for shader model 5.0 cannot put "
        "it where the layout of the source does"}));

class Taken : public testing::Test {
 protected:
  std::string made(const std::string& target, const std::string& source) {
    options.target = target;
    const auto built = build(tree.file("a.frag", source), options);
    return built ? built->output : to_string(built.diagnostics().front());
  }
  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

// By HLSL 5.0 only as a texture, which a typed view for writing is not.
TEST_F(Taken, AnImageThatIsOnlyReadIsATextureOfHlsl) {
  const std::string source =
      "layout(rgba32f) uniform readonly image2D t;\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = imageLoad(t, ivec2(0)); }\n";
  EXPECT_NE(made("hlsl50", source).find("Texture2D<float4> t : register(t0)"), std::string::npos);
}

TEST_F(Taken, ALoopOverTexturesIsUnrolledByTheHlslCompiler) {
  const std::string source =
      "uniform sampler2D t[3];\nlayout(location = 0) out vec4 o;\n"
      "void main() { o = vec4(0.0); for (int i = 0; i < 3; ++i) o += textureLod(t[i], vec2(0), 0.0); }\n";
  EXPECT_NE(made("hlsl50", source).find("register(t0)"), std::string::npos);
}

TEST_F(Taken, WhatMainDoesNotReachIsNoLack) {
  EXPECT_EQ(made("msl21",
                 "double twice(double x) { return x + x; }\nlayout(location = 0) out vec4 o;\n"
                 "void main() { o = vec4(1.0); }\n")
                .find("double"),
            std::string::npos);
}

// Each kind of name, and a function that would take the place of an intrinsic one.
TEST_F(Taken, NamesThatAreWordsOfTheLanguageAreWrittenOtherwise) {
  const std::string source =
      "uniform vec4 float4; uniform sampler2D texture2d; struct thread { float matrix; };\n"
      "layout(std140) uniform kernel { thread half4; } device;\n"
      "layout(location = 0) in vec4 line; layout(location = 0) out vec4 fragment;\n"
      "vec3 mul(vec3 v, mat3 m) { return v; }\nfloat saturate(float metal) { return metal; }\n"
      "void main() {\n  float lerp = float4.x; float delete = line.y; float nullptr = delete;\n"
      "  fragment = texture(texture2d, vec2(lerp)) * device.half4.matrix * saturate(nullptr);\n"
      "  fragment.xyz += mul(vec3(1.0), mat3(lerp)) * mat3(delete);\n}\n";
  const std::string hlsl = made("hlsl50", source);
  EXPECT_NE(hlsl.find("float3 mul_("), std::string::npos) << hlsl;
  for (const char* name : {"data_float4_ ", "matrix_;", "lerp_ =", "delete_ ="})
    EXPECT_NE(hlsl.find(name), std::string::npos) << name << "\n" << hlsl;
  const std::string msl = made("msl21", source);
  for (const char* name :
       {"float4_;", "texture2d_ ", "struct thread_", "saturate_(", "delete_ =", "nullptr_ ="})
    EXPECT_NE(msl.find(name), std::string::npos) << name << "\n" << msl;
}

}  // namespace
}  // namespace gnomon::compiler
