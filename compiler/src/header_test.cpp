// SPDX-License-Identifier: MIT
// The generated header, compiled and run by a C++ compiler.
#include <nlohmann/json.hpp>

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

// Both from one shader: every value of the JSON stands in the header, and the header has no other of its
// kind.
TEST_F(Header, SaysWhatTheJsonSays) {
  tree.file("library/host/h.glsl",
            "// SPDX\n// summary: s\n// options: NAME (h): name of the sampler; FAST (off): quicker\n"
            "#ifndef H\n#define H\n#ifndef NAME\n#define NAME h\n#endif\nuniform sampler2D NAME;\n"
            "float gnomon_host_height(ivec2 i, int q) { return texelFetch(NAME, i, 0).r; }\n"
            "#endif\n");
  const std::string source =
      "#include <gnomon/host/h.glsl>\nlayout(constant_id = 3) const int STEPS = 4;\n"
      "layout(push_constant) uniform Push { vec4 p; mat4 m[2]; } push;\nuniform float loose;\n"
      "layout(std430) readonly buffer Read { uint n; float list[]; };\nlayout(std430) buffer Both { vec3 "
      "both[2][3]; };\n"
      "layout(input_attachment_index = 1) uniform subpassInput s;\nlayout(location = 2) in vec3 v;\n"
      "layout(location = 1) out vec4 o;\n"
      "void main() { both[0][0] = v; o = push.p * push.m[0] * loose * list[n] * float(STEPS) + "
      "subpassLoad(s) +\n"
      "  gnomon_host_height(ivec2(0), 0); }\n";
  options.embedded = {"vulkan"};
  options.defines = {{"FAST", "\"1\""}};
  make("a.frag", source);
  options.target = "vulkan";
  const auto built = build(tree.path("a.frag"), options);
  ASSERT_TRUE(built) << to_string(built.diagnostics().front());
  const auto json = nlohmann::json::parse(to_json(built->reflection));
  std::string checks = "namespace s = gnomon_shaders::a_frag::vulkan;\nint wrong = 0;\n";
  const auto check = [&](const std::string& name, const nlohmann::json& value) {
    checks += "if (s::" + name + " != " + value.dump() + ") ++wrong;\n";
  };
  const auto check_all = [&](const std::string& object, const nlohmann::json& keys) {
    for (const auto& [key, value] : keys.items())
      check(object + "." + (key == "row_major" ? "is_row_major" : key), value);
  };
  for (const char* list : {"inputs", "outputs", "uniforms", "textures"}) {
    check(std::string(list) + "::all.size()", json[list].size());
    for (const auto& variable : json[list])
      check_all(std::string(list) + "::" + variable["name"].get<std::string>(), variable);
  }
  for (auto block : json["blocks"]) {
    const std::string name = "blocks::" + block["name"].get<std::string>();
    for (const auto& member : block["members"])
      check_all(name + "::" + member["name"].get<std::string>(), member);
    check(name + "::is_readonly", block.contains("readonly"));
    block.erase("members");
    block.erase("readonly");
    for (const auto& [key, value] : block.items()) check(name + "::" + key, value);
  }
  check("constants::STEPS", json["constants"][0]["id"]);
  check("host_functions[0].name", json["host_functions"][0]["name"]);
  check("host_functions[0].file", json["host_functions"][0]["file"]);
  ASSERT_EQ(json["options"].size(), 2u);
  for (size_t i = 0; i < 2; ++i) {
    const std::string option = "options[" + std::to_string(i) + "].";
    check(option + "name", json["options"][i]["name"]);
    check(option + "value", json["options"][i]["value"]);
    check(option + "default_value", json["options"][i]["default"]);
  }
  check("spirv_size", json["spirv_size"]);
  check("spirv.size() * 4", json["spirv_size"]);
  EXPECT_EQ(run("#include \"a.frag.h\"\n", checks + "return wrong;"), 0) << checks;
}

TEST_F(Header, LongTextsAreWhole) {
  std::string source;
  for (int i = 0; i < 4000; ++i) source += "// a line that is long enough\n";
  make("long.frag", source + "void main() {}\n// the end");
  EXPECT_EQ(run("#include \"long.frag.h\"\n",
                "const auto source = gnomon_shaders::long_frag::glsl450::source;\n"
                "return source.size() > 120000 && source.substr(source.size() - 11) == \"// the end\\n\" &&\n"
                "    std::strlen(source.data()) == source.size() ? 0 : 3;"),
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
