// SPDX-License-Identifier: MIT
#include "excess.h"

#include <gtest/gtest.h>

namespace gnomon::compiler {
namespace {

int line_of_excess(const std::string& text) {
  const auto excess = find_excess(text);
  return excess ? excess->line : 0;
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

// Each macro of the chain is written twice in the next.
std::string doubling(const std::string& parameter, const std::string& argument, int count) {
  std::string text = "#define A0" + parameter + " " + (argument.empty() ? "y" : "x") + "\n";
  for (int i = 1; i < count; ++i) {
    const std::string before = "A" + std::to_string(i - 1) + argument;
    text += "#define A" + std::to_string(i) + parameter + " " + before + ", " + before + "\n";
  }
  return text;
}

TEST(Limits, MacrosThatDoubleEachOther) {
  EXPECT_EQ(line_of_excess(doubling("", "", 40) + "f(A39);\n"), 41);
  EXPECT_EQ(line_of_excess(doubling("(x)", "(x)", 40) + "f(A39(1));\n"), 41);
  EXPECT_EQ(line_of_excess(doubling("", "", 40) + "#if A39\n#endif\n"), 41);
  EXPECT_EQ(line_of_excess(doubling("", "", 10) + "f(A9);\n"), 0);
  EXPECT_EQ(line_of_excess(doubling("", "", 40)), 0) << "unused, they cost nothing";
}

TEST(Limits, MacroCallsWithinEachOther) {
  const std::string twice = "#define TWICE(x) x, x\n";
  EXPECT_EQ(line_of_excess(twice + "f(" + repeated("TWICE(", 40) + "1" + repeated(")", 40) + ");\n"), 2);
  EXPECT_EQ(line_of_excess(twice + "f(" + repeated("TWICE(", 8) + "1" + repeated(")", 8) + ");\n"), 0);
}

TEST(Limits, AMacroIsNotExpandedWithinItself) {
  EXPECT_EQ(line_of_excess("#define A A + A + B\n#define B A + A\nx = A;\n"), 0);
}

TEST(Limits, StructuresThatDoubleEachOther) {
  std::string text = "struct S0 { float a, b; };\n";
  for (int i = 1; i < 30; ++i) {
    const std::string before = "S" + std::to_string(i - 1);
    text += "struct S" + std::to_string(i) + " { " + before + " a; " + before + " b; };\n";
  }
  EXPECT_EQ(line_of_excess(text), 14);
  EXPECT_EQ(line_of_excess("struct A { float a[1000000]; };\nstruct B { A a, b; A c[5000]; };\n"), 0);
}

TEST(Limits, LongExpressions) {
  EXPECT_EQ(line_of_excess("\nx = a" + repeated(" + a", 5000) + ";\n"), 2);
  EXPECT_EQ(line_of_excess("\nx = a" + repeated(".b", 5000) + ";\n"), 2);
  EXPECT_EQ(line_of_excess("\nx = f(g(1, 2)" + repeated(" * f(1, -2)", 5000) + ");\n"), 2);
  EXPECT_EQ(line_of_excess("#define SUM a" + repeated(" + a", 5000) + "\nx = SUM;\n"), 2);
}

TEST(Limits, LongTablesAndProgramsAreFine) {
  EXPECT_EQ(line_of_excess("float t[] = float[](1.5" + repeated(", -1.5 * 2.0", 20000) + ");\n"), 0);
  EXPECT_EQ(line_of_excess(repeated("x = a + b;\n", 20000)), 0);
  EXPECT_EQ(line_of_excess("// " + repeated("+ a ", 20000) + "\n"), 0);
}

}  // namespace
}  // namespace gnomon::compiler
