// SPDX-License-Identifier: MIT
// What the reflection says of a shader, for targets that number things and for those that name them.
#include "gnomon/compiler/reflection.h"

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
    "in vec2 texel; flat in int row;\n"
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
    EXPECT_FALSE(block.is_storage);
    EXPECT_EQ(block.size, 2 * 16 + 64 + 3 * 16);
    ASSERT_EQ(block.members.size(), 6u) << target;
    EXPECT_EQ(block.members[1].name, "lights[0].power");
    EXPECT_EQ(block.members[1].offset, 12);
    EXPECT_EQ(block.members[2].offset, 16);
    EXPECT_EQ(block.members[4].name, "to_world");
    EXPECT_EQ(block.members[4].offset, 32);
    EXPECT_EQ(block.members[5].offset, 96);
    EXPECT_EQ(block.members[5].array_size, 3);
    EXPECT_EQ(block.members[5].array_stride, 16);
  }
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
  EXPECT_TRUE(r.blocks[0].is_storage);
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

TEST_F(Reflected, JsonIsTheSameFromAnyFolder) {
  const Reflection here = reflect("vulkan", "a.frag", kFragment);
  const Reflection there = reflect("vulkan", "deep/er/a.frag", kFragment);
  EXPECT_EQ(to_json(here), to_json(there));
  EXPECT_NE(to_json(here).find("\"name\": \"gnomon_uniforms\""), std::string::npos);
}

}  // namespace
}  // namespace gnomon::compiler
