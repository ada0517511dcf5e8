// SPDX-License-Identifier: MIT
#include "declarations.h"

#include <gtest/gtest.h>

namespace gnomon::compiler {
namespace {

TEST(Uniforms, WhoseNameIsTaken) {
  for (const std::string earlier :
       {"uniform float turn;", "out vec4 turn;", "const int a = 1, turn = 2;", "float turn[2];",
        "struct turn { float a; };", "struct A { float a; } turn;", "uniform turn { float a; };",
        "uniform B { float turn; };", "uniform B { float a; } turn;", "uniform sampler2D turn;",
        "layout(location = 0) in vec3 turn;"}) {
    const auto collision = find_uniform_collision(earlier + "\nuniform mat3 turn;\n");
    ASSERT_TRUE(collision) << earlier;
    EXPECT_EQ(collision->line, 2) << earlier;
    EXPECT_EQ(collision->related, 1) << earlier;
  }
}

TEST(Uniforms, WhoseNameIsFree) {
  for (const std::string earlier :
       {"float f(float turn) { float x = turn; return x; }", "struct A { float turn; };",
        "uniform B { float turn; } b;", "float a = float(turn);", "void turn() {}", "float turn(float x);",
        "layout(std140) uniform; layout(row_major) uniform;",
        "layout(binding = turn) uniform sampler2D a;"}) {
    EXPECT_FALSE(find_uniform_collision(earlier + "\nuniform mat3 turn, other;\nuniform float last;\n"))
        << earlier;
  }
}

TEST(Uniforms, TextThatIsCutOffOrUnbalanced) {
  for (const std::string text :
       {"uniform", "uniform float a[", "uniform B { float a", "}}})) uniform float a;", "uniform float a = (",
        "#line 3\nuniform float a", ";;,=,;"}) {
    EXPECT_FALSE(find_uniform_collision(text)) << text;
  }
}

}  // namespace
}  // namespace gnomon::compiler
