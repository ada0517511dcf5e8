// SPDX-License-Identifier: MIT
#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Check : public testing::Test {
 protected:
  std::string error_of(const std::string& path) const {
    const auto checked = check(path, options);
    return checked ? "no error" : tree.relative(to_string(checked.diagnostics().front()));
  }
  std::string error_in(const std::string& module) const { return error_of(tree.file("m.glsl", module)); }
  std::string text_for(const std::string& module) const {
    const auto checked = check(tree.file("m.glsl", module), options);
    return checked ? checked->output : to_string(checked.diagnostics().front());
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Check, CallsEveryFunctionAndUsesItsResults) {
  const std::string text = text_for(
      "#define GNOMON_OUT(type) out type\n"
      "struct Map { ivec2 size; float highest; };\n"
      "float twice(float x) { return 2.0f * x; }\n"
      "Map grown(Map map, GNOMON_OUT(vec2) by) { by = vec2(1.0f, 1.0f); map.highest += by.x; return map; }\n"
      "void nothing() {}\n");
  EXPECT_NE(text.find("float gnomon_check_0; gnomon_check_0 = float(gnomon_check_input + 1.0); "
                      "float gnomon_check_returned = twice(gnomon_check_0); "
                      "gnomon_check_sum += 0.0 + float(gnomon_check_returned);"),
            std::string::npos)
      << text;
  EXPECT_NE(
      text.find("Map gnomon_check_returned = grown(gnomon_check_0, gnomon_check_1); gnomon_check_sum += 0.0"
                " + float(gnomon_check_1[0]) + float(gnomon_check_1[1])"
                " + float(gnomon_check_returned.size[0]) + float(gnomon_check_returned.size[1])"
                " + float(gnomon_check_returned.highest);"),
      std::string::npos)
      << text;
  EXPECT_NE(text.find("nothing();"), std::string::npos) << text;
}

TEST_F(Check, CallsTheFunctionsOfIncludesToo) {
  tree.file("b.glsl", "float b(float x) { return x; }\n");
  EXPECT_NE(text_for("#include \"b.glsl\"\nfloat a() { return 1.0f; }\n").find("= b(gnomon_check_0)"),
            std::string::npos);
}

TEST_F(Check, ErrorInAFunctionThatNobodyCalls) {
  EXPECT_EQ(error_in("float unused(ivec2 a) {\n  float b = a;\n  return b;\n}\n"),
            "m.glsl:2: error: cannot convert from 'ivec2' to 'float'");
}

// Nothing is wrong with either function until a program holds both.
TEST_F(Check, ErrorThatOnlyACallReveals) {
  EXPECT_EQ(error_in("float even(int n);\nfloat odd(int n) { return even(n - 1); }\n"
                     "float even(int n) { return odd(n - 1); }\n"),
            "m.glsl:3: error: function 'even' calls itself, directly or through others: GLSL has no "
            "recursion, write a "
            "loop with a bound");
}

TEST_F(Check, HostFunctionsGetABody) {
  const std::string text = text_for(
      "struct Hit { float t; bool any; };\n"
      "Hit gnomon_host_hit(const in vec3 from, inout int steps, out float depth);\n"
      "void gnomon_host_note(float value);\n"
      "float gnomon_host_never_called();\n"
      "float f(vec3 p) { int n = 1; float d; Hit h = gnomon_host_hit(p, n, d); gnomon_host_note(d); return "
      "h.t; }\n");
  EXPECT_NE(text.find("Hit gnomon_host_hit(const in vec3 gnomon_check_0, inout int gnomon_check_1, "
                      "out float gnomon_check_2) {"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("void gnomon_host_note(in float gnomon_check_0) {"), std::string::npos) << text;
}

TEST_F(Check, EveryKindOfParameter) {
  EXPECT_EQ(
      error_in(
          "struct Inner { mat2 m; float w[3]; };\nstruct Outer { Inner inner[2]; uint u; bool b; };\n"
          "vec4 f(sampler2D t, usampler2D i, Outer o, mat3x2 m, float[2][3] w, bvec2 b, uvec3 u, dvec2 d,\n"
          "       float, inout Inner io) { io = o.inner[1]; return texture(t, m[0] + vec2(u.x)); }\n"
          "Outer g(Outer o) { return o; }\n"
          "float h(float x) { return x; }\nfloat h(vec2 x) { return x.x; }\n"),
      "no error");
}

TEST_F(Check, HugeTypesEndInAResult) {
  EXPECT_EQ(error_in("struct S { float a[1000000]; int b; };\nS f(S s) { return s; }\nS host(S s);\n"
                     "S g(S s) { return host(s); }\n"),
            "no error");
}

TEST_F(Check, StructuresOfSamplers) {
  EXPECT_EQ(error_in("struct Maps { sampler2D height[2]; float scale; };\n"
                     "float f(Maps maps) { return texture(maps.height[1], vec2(0.5f)).x * maps.scale; }\n"),
            "no error");
}

TEST_F(Check, EveryStage) {
  const std::string module = "float host(int);\nfloat f(float x) { return x + host(1); }\n";
  for (const StageName& row : stages()) {
    EXPECT_EQ(error_of(tree.file("m." + row.name, module)), "no error") << row.name;
    options.stage = row.stage;
    EXPECT_EQ(error_in(module), "no error") << row.name;
    options.stage = std::nullopt;
  }
  // Without a word about it, a module is for fragment shaders.
  EXPECT_EQ(error_in("float f(float x) { return dFdx(x); }\n"), "no error");
  options.stage = Stage::kVertex;
  EXPECT_TRUE(error_in("float f(float x) { return dFdx(x); }\n").starts_with("m.glsl:1: error: "));
}

TEST_F(Check, ModuleMayDeclareItsOwnOutputs) {
  EXPECT_EQ(error_in("layout(location = 0) out vec4 o;\nvoid write(float x) { o = vec4(x); }\n"), "no error");
}

TEST_F(Check, ShaderWithMainIsTakenAsItIs) {
  const std::string path = tree.file("a.frag", "void main() {}\n");
  ASSERT_TRUE(check(path, options));
  EXPECT_EQ(check(path, options)->output, assemble(path, options)->text);
  EXPECT_EQ(
      error_of(tree.file("b.frag", "float f();\nout float o;\nvoid main() { o = f(); }\n")),
      "b.frag:1: error: function 'f' is declared and called, but not defined: define it, or include the file "
      "that does");
}

TEST_F(Check, EmptyModule) {
  EXPECT_EQ(error_in("// nothing\n"), "no error");
}

TEST_F(Check, DeepLoopsAndConditionsAreRefused) {
  const auto error = [&](int count, const std::string& before, const std::string& after) {
    std::string text = "float f(float x, int n) {\n";
    for (int i = 0; i < count; ++i) text += before;
    text += "x += 1.0;";
    for (int i = 0; i < count; ++i) text += after;
    const auto checked = check(tree.file("m.glsl", text + "\nreturn x;\n}\n"), options);
    return checked ? "" : tree.relative(to_string(checked.diagnostics().front()));
  };
  const std::string loop = "for (int i = 0; i < n; ++i) ";
  EXPECT_EQ(error(60, loop, ""), "");
  EXPECT_EQ(error(70, loop, ""),
            "m.glsl:2: error: loops are nested more than 64 deep: move the inner ones into a function");
  EXPECT_EQ(error(200, "if (n > 1) {", "}"), "");
  EXPECT_TRUE(error(300, "if (n > 1) {", "}").starts_with("m.glsl:2: error: conditions"))
      << error(300, "if (n > 1) {", "}");
}

TEST_F(Check, ImagesThatAreWrittenAreParametersToo) {
  const std::string module =
      tree.file("m.glsl",
                "#ifdef GL_ES\n#define HIGHP highp\n#else\n#define HIGHP\n#endif\n"
                "void put(writeonly HIGHP image2D i, vec4 x) { imageStore(i, ivec2(0), x); }\n"
                "void whole(writeonly HIGHP iimage2D i) { imageStore(i, ivec2(0), ivec4(1)); }\n");
  for (const std::string target : {"glsl450", "vulkan", "essl310"}) {
    options.target = target;
    const auto checked = check(module, options);
    EXPECT_TRUE(checked) << target << ": " << to_string(checked.diagnostics().front());
  }
}

}  // namespace
}  // namespace gnomon::compiler
