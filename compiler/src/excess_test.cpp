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

int line_of_depth(const std::string& text, bool becomes_spirv = true) {
  const auto depth = find_depth(text, becomes_spirv);
  return depth ? depth->line : 0;
}

// "struct S1 { S0 a; };" and so on, a line each.
std::string nested_structures(int count) {
  std::string text = "struct S0 { float a; };\n";
  for (int i = 1; i < count; ++i)
    text += "struct S" + std::to_string(i) + " { S" + std::to_string(i - 1) + " a; };\n";
  return text;
}

std::string functions(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += "float f" + std::to_string(i) + "(float x) { return x; }\n";
  return text;
}

TEST(Limits, MacrosThatUseEachOtherTooDeep) {
  std::string text = "#define A0 y\n";
  for (int i = 1; i < 30000; ++i)
    text += "#define A" + std::to_string(i) + " A" + std::to_string(i - 1) + "-1\n";
  EXPECT_EQ(line_of_excess(text + "x = A100;\n"), 0);
  EXPECT_EQ(line_of_excess(text + "x = A29999;\n"), 30001);
}

TEST(Limits, MacrosCalledInArgumentsTooDeep) {
  const std::string macro = "#define F(x) x\n";
  EXPECT_EQ(line_of_excess(macro + "y = " + repeated("F(", 20000) + "1" + repeated(")", 20000) + ";\n"), 2);
  EXPECT_EQ(line_of_excess(macro + repeated("y = F(1);\n", 2000)), 0);
}

TEST(Limits, ConditionsWithManyParentheses) {
  const std::string deep = repeated("(", 50000) + "1" + repeated(")", 50000);
  EXPECT_EQ(line_of_excess("#if " + deep + "\n#endif\n"), 1);
  EXPECT_EQ(line_of_excess("#define DEEP " + deep + "\n#if DEEP\n#endif\n"), 2);
}

TEST(Limits, CommasThatAreOperators) {
  const std::string many = repeated("a, ", 5000) + "a";
  for (const std::string& text : std::vector<std::string>{
           "x = (" + many + ");", many + ";", "return " + many + ";", "x = b[" + many + "];",
           "for (;; " + many + ") ;", "f((" + many + "));", "float x = (" + many + ");"})
    EXPECT_EQ(line_of_depth("\n" + text + "\n"), 2) << text.substr(0, 20);
  for (const std::string& text :
       std::vector<std::string>{"float " + many + ";", "const highp vec2[3] " + many + ";",
                                "f(" + many + ");", "float t[] = float[](" + many + ");",
                                "float t[] = {" + many + "};", "float t[][2] = {{" + many + "}, {a, a}};"})
    EXPECT_EQ(line_of_depth(text), 0) << text.substr(0, 20);
}

TEST(Limits, StructuresInEachOther) {
  EXPECT_EQ(line_of_depth(nested_structures(100)), 0);
  EXPECT_EQ(line_of_depth(nested_structures(9000)), 201);
}

TEST(Limits, ManyFunctionsCallsAndCases) {
  EXPECT_EQ(line_of_depth(functions(2000)), 0);
  EXPECT_EQ(line_of_depth(functions(2001)), 2001);
  std::string calls = functions(1000);
  for (int i = 0; i < 6; ++i) {
    calls += "void g" + std::to_string(i) + "() {";
    for (int k = 0; k < 1000; ++k) calls += "f" + std::to_string(k) + "(1.0);";
    calls += "}\n";
  }
  EXPECT_EQ(line_of_depth(calls), 1006);
  EXPECT_EQ(line_of_depth(functions(1) + "void g() {" + repeated("f0(1.0);", 9000) + "}\n"), 0);
  EXPECT_EQ(line_of_depth("void f() { switch (1) {\n" + repeated("case 1:\n", 3000) + "} }\n"), 1002);
}

TEST(Limits, TablesOfNumbersInSpirv) {
  std::string table = "float t[] = float[](0.0";
  for (int i = 1; i < 20000; ++i) table += ", " + std::to_string(i) + ".5";
  EXPECT_EQ(line_of_depth("\n" + table + ");\n"), 2);
  EXPECT_EQ(line_of_depth(table + ");\n", false), 0);
}

TEST(Limits, ALongTableIsNotBlamedOnMacros) {
  const auto excess = find_excess("float t[] = float[](1" + repeated(",1", 600000) + ");\n");
  ASSERT_TRUE(excess);
  EXPECT_EQ(excess->text.find("macro"), std::string::npos) << excess->text;
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
  EXPECT_EQ(line_of_depth(text), 14);
  EXPECT_EQ(line_of_depth("struct A { float a[1000000]; };\nstruct B { A a, b; A c[5000]; };\n"), 0);
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
