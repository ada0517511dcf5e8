// SPDX-License-Identifier: MIT
// What the reflection says of a shader, for targets that number things and for those that name them.
#include "gnomon/compiler/reflection.h"

#include <array>
#include <map>
#include <spirv_cross/spirv_cross.hpp>

#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Reflected : public testing::Test {
 protected:
  Reflection reflect(const std::string& target, const std::string& name, const std::string& source) {
    options.target = target;
    const auto built = build(tree.file(name, source), options);
    if (built) return built->reflection;
    ADD_FAILURE() << to_string(built.diagnostics().front());
    return {};
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

constexpr const char* kFragment =
    "struct Light { vec3 at; float power; };\n"
    "layout(std140) uniform Lights { Light lights[2]; mat4 to_world; float sizes[3]; };\n"
    "uniform vec3 b; uniform float a[4]; uniform float unused;\n"
    "uniform highp sampler2D heights; uniform highp sampler2DArray layers;\n"
    "layout(location = 0) in vec2 texel; layout(location = 1) flat in int row;\n"
    "layout(location = 1) out vec4 second; layout(location = 0) out vec4 first;\n"
    "void main() {\n"
    "  first = vec4(b * a[1] + lights[1].at * sizes[2], texel.x) + to_world[0];\n"
    "  second = texture(heights, texel) + texture(layers, vec3(texel, row));\n"
    "}\n";

std::vector<std::string> names(const std::vector<Variable>& variables) {
  std::vector<std::string> list;
  for (const Variable& variable : variables) list.push_back(variable.name + ":" + variable.type);
  return list;
}

using List = std::vector<std::string>;

TEST_F(Reflected, EveryKindOfVariableInAFixedOrder) {
  for (const char* target : {"glsl450", "glsl330", "essl300", "essl310", "opengl"}) {
    const Reflection r = reflect(target, "a.frag", kFragment);
    EXPECT_EQ(names(r.outputs), (List{"first:vec4", "second:vec4"})) << target;
    EXPECT_EQ(names(r.uniforms), (List{"a:float", "b:vec3"})) << target;
    EXPECT_EQ(names(r.textures), (List{"heights:sampler2D", "layers:sampler2DArray"})) << target;
    EXPECT_EQ(r.uniforms.at(0).array_size, 4);
    ASSERT_EQ(r.blocks.size(), 1u);
    EXPECT_EQ(r.stage, Stage::kFragment);
  }
  EXPECT_EQ(names(reflect("glsl330", "a.frag", kFragment).inputs), (List{"row:int", "texel:vec2"}));
  // By the location that the target numbers them with.
  EXPECT_EQ(names(reflect("opengl", "a.frag", kFragment).inputs), (List{"texel:vec2", "row:int"}));
}

TEST_F(Reflected, BlocksHaveOffsetsByStd140) {
  for (const char* target : {"glsl330", "essl310", "vulkan", "hlsl50"}) {
    const Reflection r = reflect(target, "a.frag", kFragment);
    const Block& block = r.blocks.front();
    EXPECT_EQ(block.name, "Lights");
    EXPECT_EQ(block.kind, BlockKind::kUniform);
    EXPECT_EQ(block.size, 2 * 16 + 64 + 3 * 16);
    ASSERT_EQ(block.members.size(), 5u) << target;
    EXPECT_EQ(block.members[0].name, "lights");
    EXPECT_EQ(block.members[0].array_stride, 16);
    EXPECT_EQ(block.members[2].name, "lights[0].power");
    EXPECT_EQ(block.members[2].offset, 12);
    EXPECT_EQ(block.members[3].name, "to_world");
    EXPECT_EQ(block.members[3].offset, 32);
    EXPECT_EQ(block.members[3].matrix_stride, 16);
    EXPECT_EQ(block.members[4].offset, 96);
    EXPECT_EQ(block.members[4].array_size, 3);
    EXPECT_EQ(block.members[4].array_stride, 16);
  }
}

// Every number of a block's member as SPIR-V has it, read by SPIRV-Cross.
class Decorations {
 public:
  explicit Decorations(const std::string& spirv)
      : compiler_(reinterpret_cast<const std::uint32_t*>(spirv.data()), spirv.size() / 4) {
    for (const auto& block : compiler_.get_shader_resources().uniform_buffers)
      add(compiler_.get_type(block.base_type_id), "", 0);
  }
  std::map<std::string, std::array<int, 3>> members;  // offset, array stride, matrix stride; 0: none

 private:
  void add(const spirv_cross::SPIRType& block, const std::string& prefix, int base) {
    for (std::uint32_t i = 0; i < block.member_types.size(); ++i) {
      const spirv_cross::SPIRType& type = compiler_.get_type(block.member_types[i]);
      const std::string name = prefix + compiler_.get_member_name(block.self, i);
      const int offset = base + static_cast<int>(compiler_.type_struct_member_offset(block, i));
      const bool is_array = !type.array.empty();
      members[name] = {
          offset, is_array ? static_cast<int>(compiler_.type_struct_member_array_stride(block, i)) : 0,
          type.columns > 1 ? static_cast<int>(compiler_.type_struct_member_matrix_stride(block, i)) : 0};
      if (type.basetype == spirv_cross::SPIRType::Struct) add(type, name + (is_array ? "[0]." : "."), offset);
    }
  }
  spirv_cross::Compiler compiler_;
};

TEST_F(Reflected, BytesOfBlocksAreThoseOfTheSpirv) {
  const std::string source =
      "struct L { vec3 p; float r[2]; mat3 m; float last; };\nuniform float w[4]; uniform mat2 n[2]; uniform "
      "L one;\n"
      "uniform L lights[3]; uniform bool flag; uniform mat3x2 wide;\n"
      "layout(std140, row_major) uniform B { float a; mat2x3 rows; L inner[2]; layout(offset = 512) vec2 "
      "far; };\n"
      "layout(location = 0) out vec4 o;\n"
      "void main() { o = vec4(w[1] + n[1][0].x + one.r[1] + lights[2].m[0].x + a + inner[1].last + far.x +\n"
      "  (flag ? wide[0].x : rows[0].x)); }\n";
  options.target = "vulkan";
  const auto built = build(tree.file("a.frag", source), options);
  ASSERT_TRUE(built) << to_string(built.diagnostics().front());
  const Decorations expected(built->output);
  size_t count = 0;
  for (const Block& block : built->reflection.blocks) {
    for (const Member& m : block.members) {
      ASSERT_TRUE(expected.members.contains(m.name)) << m.name;
      const std::array numbers = {m.offset.value_or(0), m.array_stride.value_or(0),
                                  m.matrix_stride.value_or(0)};
      EXPECT_EQ(numbers, expected.members.at(m.name)) << m.name;
      ++count;
    }
  }
  EXPECT_EQ(count, expected.members.size());
}

TEST_F(Reflected, TheDriverLaysOutOtherBlocksOfGlsl) {
  const std::string source =
      "uniform B { float a[3]; vec3 v; }; out vec4 o; void main() { o = vec4(a[1] + v.x); }";
  const Block block = reflect("glsl330", "a.frag", source).blocks.at(0);
  EXPECT_EQ(block.size, std::nullopt);
  EXPECT_EQ(block.members.at(1).offset, std::nullopt);
  EXPECT_EQ(block.members.at(0).array_size, 3);
  EXPECT_EQ(reflect("opengl", "a.frag", source).blocks.at(0).size, 64);
}

// As GL_UNIFORM_BLOCK_DATA_SIZE tells it.
TEST_F(Reflected, SizesAreWhatToAllocate) {
  const std::string source =
      "layout(std140) uniform B { mat4 m; float t; }; layout(location = 0) out vec4 o; void main() { o = "
      "m[0] * t; }";
  for (const char* target : {"glsl450", "vulkan"})
    EXPECT_EQ(reflect(target, "a.frag", source).blocks.at(0).size, 80);
}

// What the host adds is the bytes of the elements that it wants.
TEST_F(Reflected, SizesAreWithoutTheArrayThatHasNone) {
  const std::string source =
      "layout(local_size_x = 8) in;\nlayout(std430, binding = 0) buffer A { float a[]; };\n"
      "layout(std430, binding = 1) buffer B { uint n; float b[]; };\n"
      "layout(std140, binding = 2) buffer C { uint m; vec4 c[]; };\n"
      "layout(std430, binding = 3) buffer D { float d[2][3]; };\n"
      "void main() { a[0] = b[n] + c[m].x + d[1][2]; }\n";
  for (const char* target : {"glsl450", "essl310", "vulkan", "opengl", "hlsl50", "msl21"}) {
    const Reflection r = reflect(target, "a.comp", source);
    ASSERT_EQ(r.blocks.size(), 4u);
    EXPECT_EQ(r.blocks[0].size, 0) << target;
    EXPECT_EQ(r.blocks[1].size, 4) << target;
    EXPECT_EQ(r.blocks[2].size, 16) << target;
    EXPECT_EQ(r.blocks[3].size, 24) << target;
    const Member& all = r.blocks[3].members.at(0);
    EXPECT_EQ(all.type, "float");
    EXPECT_EQ(all.array_size, 6);
    EXPECT_EQ(all.array_stride, 4);
  }
}

TEST_F(Reflected, WhatTakesMoreBytesThanAnIntCountsIsRefused) {
  for (const char* target : {"glsl450", "glsl330", "vulkan", "opengl", "hlsl50"}) {
    options.target = target;
    const auto built =
        build(tree.file("a.frag",
                        "layout(std140) uniform B {\n  float first;\n  mat4 m[2000000000];\n};\n"
                        "out vec4 o;\nvoid main() {\n  o = m[3][0];\n}\n"),
              options);
    ASSERT_FALSE(built) << target;
    EXPECT_NE(to_string(built.diagnostics().front()).find("takes more than 2147483647 bytes"),
              std::string::npos)
        << to_string(built.diagnostics().front());
  }
}

TEST_F(Reflected, OnlyWhatIsUsedIsListed) {
  const Reflection r = reflect("glsl450", "a.vert",
                               "in vec4 a; in vec4 unused; uniform float u; uniform float v;\n"
                               "float never() { return v; }\nvoid main() { gl_Position = a * u; }\n");
  EXPECT_EQ(names(r.inputs), (List{"a:vec4"}));
  EXPECT_EQ(names(r.outputs), (List{"gl_Position:vec4"}));
  EXPECT_EQ(names(r.uniforms), (List{"u:float"}));
}

TEST_F(Reflected, StructuresAndBlocksBetweenStagesKeepTheirLocation) {
  const Reflection r =
      reflect("vulkan", "a.vert",
              "struct V { vec3 n; vec2 uv; }; layout(location = 3) out V v;\n"
              "layout(location = 9) out Blk { vec4 a; vec2 b; } blk;\n"
              "void main() { v.n = vec3(0); v.uv = vec2(0); blk.a = vec4(0); blk.b = vec2(0); }\n");
  ASSERT_EQ(r.outputs.size(), 2u);
  EXPECT_EQ(r.outputs[0].name, "v");
  EXPECT_EQ(r.outputs[0].location, 3);
  EXPECT_EQ(r.outputs[1].name, "blk");
  EXPECT_EQ(r.outputs[1].location, 9);
}

TEST_F(Reflected, VulkansOwnKinds) {
  const Reflection r = reflect("vulkan", "a.frag",
                               "layout(push_constant) uniform Push { vec4 p; } push;\n"
                               "layout(constant_id = 3) const int STEPS = 4;\n"
                               "layout(input_attachment_index = 1, binding = 2) uniform subpassInput s;\n"
                               "layout(std140, binding = 7) uniform Camera { vec4 x; } cam[2];\n"
                               "layout(location = 0) out vec4 o;\n"
                               "void main() { o = push.p * float(STEPS) + subpassLoad(s) + cam[1].x; }\n");
  ASSERT_EQ(r.blocks.size(), 2u);
  EXPECT_EQ(r.blocks[0].array_size, 2);
  EXPECT_EQ(r.blocks[0].binding, 7);
  EXPECT_EQ(r.blocks[1].kind, BlockKind::kPushConstant);
  EXPECT_EQ(r.blocks[1].binding, std::nullopt);
  ASSERT_EQ(r.constants.size(), 1u);
  EXPECT_EQ(r.constants[0].id, 3);
  EXPECT_EQ(r.textures.at(0).input_attachment_index, 1);
}

TEST_F(Reflected, LooseUniformsAreABlockForVulkan) {
  const Reflection r = reflect("vulkan", "a.frag", kFragment);
  EXPECT_TRUE(r.uniforms.empty());
  ASSERT_EQ(r.blocks.size(), 2u);
  EXPECT_EQ(r.blocks[1].name, "gnomon_uniforms");
  EXPECT_EQ(r.textures.at(0).set, 0);
  std::vector<int> bindings = {*r.textures.at(0).binding, *r.textures.at(1).binding, *r.blocks[0].binding,
                               *r.blocks[1].binding};
  std::sort(bindings.begin(), bindings.end());
  EXPECT_EQ(bindings, (std::vector{0, 1, 2, 3}));
}

TEST_F(Reflected, NumbersOfTheSourceStay) {
  const std::string source =
      "layout(binding = 5) uniform sampler2D a; uniform sampler2D b; layout(location = 2) out vec4 o;\n"
      "void main() { o = texture(a, vec2(0)) + texture(b, vec2(0)); }\n";
  for (const char* target : {"glsl450", "essl310", "opengl", "vulkan"})
    EXPECT_EQ(reflect(target, "a.frag", source).textures.at(0).binding, 5) << target;
  EXPECT_NE(reflect("vulkan", "a.frag", source).textures.at(1).binding, 5);
  EXPECT_EQ(reflect("glsl330", "a.frag", source).textures.at(0).binding, std::nullopt);
  EXPECT_EQ(reflect("glsl330", "a.frag", source).outputs.at(0).location, 2);
}

TEST_F(Reflected, StorageAndWorkGroupsOfAComputeShader) {
  const Reflection r = reflect("glsl450", "a.comp",
                               "layout(local_size_x = 8, local_size_y = 4) in;\n"
                               "layout(std430, binding = 1) buffer Out { uint count; float values[]; };\n"
                               "void main() { values[count] = 1.0; }\n");
  EXPECT_EQ(r.local_size, (std::vector{8, 4, 1}));
  ASSERT_EQ(r.blocks.size(), 1u);
  EXPECT_EQ(r.blocks[0].kind, BlockKind::kStorage);
  EXPECT_EQ(r.blocks[0].binding, 1);
  ASSERT_EQ(r.blocks[0].members.size(), 2u);
  EXPECT_EQ(r.blocks[0].members[1].offset, 4);
  EXPECT_EQ(r.blocks[0].members[1].array_stride, 4);
}

TEST_F(Reflected, HostFunctionsAndOptions) {
  tree.file("library/host/h.glsl",
            "// SPDX\n// summary: s\n// options: NAME (h_texture): name of the sampler;\n//          FAST "
            "(off): quicker\n"
            "#ifndef H\n#define H\n#ifndef NAME\n#define NAME h_texture\n#endif\nuniform sampler2D NAME;\n"
            "float gnomon_host_height(ivec2 i, int q) { return texelFetch(NAME, i, 0).r; }\n"
            "float gnomon_host_extrema(ivec2 b, int l, int q) { return 1.0; }\n#endif\n");
  const std::string source =
      "#include <gnomon/host/h.glsl>\nout vec4 o;\nvoid main() { o = vec4(gnomon_host_height(ivec2(0), 0)); "
      "}\n";
  Reflection r = reflect("glsl450", "a.frag", source);
  ASSERT_EQ(r.host_functions.size(), 1u);
  EXPECT_EQ(r.host_functions[0].name, "gnomon_host_height");
  EXPECT_EQ(r.host_functions[0].file, "gnomon/host/h.glsl");
  ASSERT_EQ(r.options.size(), 2u);
  EXPECT_EQ(r.options[0].name, "FAST");
  EXPECT_EQ(r.options[0].value, "off");
  EXPECT_EQ(r.options[1].value, "h_texture");
  options.defines = {{"NAME", "mine"}, {"FAST", "1"}};
  r = reflect("glsl450", "a.frag", source);
  EXPECT_EQ(r.options[0].value, "1");
  EXPECT_EQ(r.options[1].value, "mine");
  EXPECT_EQ(r.options[1].default_value, "h_texture");
}

TEST_F(Reflected, HostFunctionsThatMainDoesNotReachAreNotListed) {
  const Reflection r = reflect(
      "vulkan", "a.frag",
      "float gnomon_host_height(ivec2 i, int q) { return 1.0; }\n"
      "float gnomon_host_extrema(ivec2 b, int l, int q) { return 1.0; }\n"
      "float never() { return gnomon_host_extrema(ivec2(0), 0, 0); }\n"
      "float ever() { return gnomon_host_height(ivec2(0), 0); }\n"
      "layout(location = 0) out vec4 o;\nvoid main() { o = vec4(ever()); if (false) o.x = never(); }\n");
  ASSERT_EQ(r.host_functions.size(), 1u);
  EXPECT_EQ(r.host_functions[0].name, "gnomon_host_height");
}

TEST_F(Reflected, JsonIsTheSameFromAnyFolder) {
  const Reflection here = reflect("vulkan", "a.frag", kFragment);
  const Reflection there = reflect("vulkan", "deep/er/a.frag", kFragment);
  EXPECT_EQ(to_json(here), to_json(there));
  EXPECT_NE(to_json(here).find("\"name\": \"gnomon_uniforms\""), std::string::npos);
}

}  // namespace
}  // namespace gnomon::compiler
