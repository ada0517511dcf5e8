// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "gnomon/compiler/compiler.h"

namespace gnomon::compiler {
namespace {

std::string error_of(const std::string& text) {
  const auto define = parse_define(text);
  return define ? "no error" : define.diagnostics().front().message;
}

TEST(Define, NameAndValue) {
  EXPECT_EQ(parse_define("A")->value, "1");
  EXPECT_EQ(parse_define("A=")->value, "");
  EXPECT_EQ(parse_define("_a9=x = y")->name, "_a9");
  EXPECT_EQ(parse_define("_a9=x = y")->value, "x = y");
}

TEST(Define, NamesThatGlslDoesNotAllow) {
  for (const std::string bad : {"", "=1", "1A", "A B=1", "A(x)=x", "A-B", "\xC3\xA9"}) {
    EXPECT_NE(error_of(bad).find("is not an identifier"), std::string::npos) << bad;
  }
  EXPECT_EQ(error_of("gl_A"), "-D: the name \"gl_A\" starts with gl_, which GLSL reserves: choose another");
  EXPECT_EQ(error_of("GL_A"), "-D: the name \"GL_A\" starts with gl_, which GLSL reserves: choose another");
  EXPECT_EQ(error_of("A__B=2"),
            "-D: the name \"A__B\" contains a double underscore, which GLSL reserves: choose another");
  EXPECT_EQ(error_of("defined"),
            "-D: the name \"defined\" is reserved by the GLSL preprocessor: choose another");
}

TEST(Define, ValuesThatReachBeyondTheirLine) {
  EXPECT_EQ(error_of("A=1\n#define B"), "-D A: the value has a line break: write it in one line");
  EXPECT_EQ(error_of("A=1 /* x"), "-D A: the value has a comment: leave it out");
  EXPECT_EQ(error_of("A=1 // x"), "-D A: the value has a comment: leave it out");
  EXPECT_EQ(error_of("A=1\\"), "-D A: the value ends in a backslash: leave it out");
}

}  // namespace
}  // namespace gnomon::compiler
