// SPDX-License-Identifier: MIT
#include "gnomon/compiler/compiler.h"
#include "temporary_tree.h"

namespace gnomon::compiler {
namespace {

class Loops : public testing::Test {
 protected:
  // Whether the loop, within a function with these parameters, counts as bounded.
  bool bounded(const std::string& loop) const {
    const auto checked =
        check(tree.file("m.glsl",
                        "int global;\nint side() { return ++global; }\nvoid change(inout int x) { ++x; }\n"
                        "struct Limits { int most; };\n"
                        "float f(float x, int n, Limits limits, ivec2 v, int i, uint u) {\n" +
                            loop + "\nreturn x;\n}\n"),
              options);
    EXPECT_TRUE(checked) << to_string(checked.diagnostics().front());
    return checked && checked->source.warnings.empty();
  }

  TemporaryTree tree;
  Options options{.library_directory = tree.path("library")};
};

TEST_F(Loops, CounterAgainstAFixedLimitIsBounded) {
  for (const std::string header : {"int i = 0; i < 9; ++i",
                                   "int i = n; i < limits.most; i++",
                                   "int i = 0; i <= v.x + n; i += 2",
                                   "int i = n; i > 0; --i",
                                   "int i = n; i >= 0; i -= 3",
                                   "int i = 0; i != n; ++i",
                                   "int i = 0; n > i; ++i",
                                   "i = 0; i < n; ++i",
                                   "int i = 0, j = 5; i < n; ++i, --j",
                                   "int i = 0; i < n && x > 0.0; ++i",
                                   "int i = 0; i < max(n, 3); ++i",
                                   "int i = 0; i < n; i += 1 + 1",
                                   "int i = 0; i < n; i = i + 2",
                                   "int i = n; i > 0; i = i - 2",
                                   "int i = n; i > 0; i += -1",
                                   "uint i = 0u; i < u; ++i",
                                   "uint i = u; i > 0u; --i",
                                   "uint i = u; i >= 4u; i -= 4u",
                                   "uint i = u; i != 0u; --i",
                                   "int i = 0; i <= 2147483646; ++i"}) {
    EXPECT_TRUE(bounded("for (" + header + ") { if (n == 7) break; }")) << header;
  }
}

TEST_F(Loops, WithoutCounterConditionOrStepItIsNot) {
  for (const std::string header : {";;", "int i = 0;; ++i", "int i = 0; true; ++i", "; i < n; ++i",
                                   "int i = 0; i < n;", "int i = 0; x > 0.0; ++i", "int i = 0; i == n; ++i",
                                   "int i = 0; i < n || x > 0.0; ++i", "int i = 0; i < n; ++v.x"}) {
    EXPECT_FALSE(bounded("for (" + header + ") { if (++n == 7) break; x -= 1.0; }")) << header;
  }
}

TEST_F(Loops, StepAwayFromTheLimitIsNot) {
  for (const std::string header :
       {"int i = 0; i < 9; --i", "int i = 9; i > 0; ++i", "int i = 0; 9 > i; i -= 1"}) {
    EXPECT_FALSE(bounded("for (" + header + ") x += 1.0;")) << header;
  }
}

TEST_F(Loops, StepThatMayNeverComeToTheLimitIsNot) {
  for (const std::string header : {"int i = 1; i < n; i *= 2",
                                   "int i = n; i > 0; i /= 2",
                                   "int i = n; i >= 0; i >>= 1",
                                   "int i = 0; i < n; i += 0",
                                   "int i = 0; i < n; i = i",
                                   "int i = 0; i < n; i += v.x",
                                   "int i = 0; i < n; i = n - i",
                                   "int i = 0; i < n; i += 2, i -= 2",
                                   "int i = 0; i < n; n > 3 ? ++i : i",
                                   "int i = 0; i != n; i += 2",
                                   "int i = 0; i <= 2147483647; ++i",
                                   "int i = 0; i < 2147483647; i += 2",
                                   "int i = 0; i >= -2147483647 - 1; --i",
                                   "uint i = u; i >= 0u; --i",
                                   "uint i = u; i >= uint(n); --i",
                                   "uint i = u; i > 0u; i -= 2u",
                                   "uint i = 0u; i <= 4294967295u; ++i",
                                   "float t = 0.0; t < x; t += 0.1",
                                   "float t = 0.0; t < x; t += 1e-9",
                                   "float t = 0.0; t < 9.0; t += x"}) {
    EXPECT_FALSE(bounded("for (" + header + ") { if (n == 7) break; }")) << header;
  }
}

TEST_F(Loops, GlobalsMayBeModifiedByWhatIsCalled) {
  EXPECT_FALSE(bounded("for (int i = 0; i < global; ++i) side();"));
  EXPECT_FALSE(bounded("for (global = 0; global < n; ++global) side();"));
  EXPECT_TRUE(bounded("for (int i = 0; i < global; ++i) x += 1.0;"));
}

TEST_F(Loops, LimitOrCounterThatMovesIsNot) {
  for (const std::string body : {"++n", "n = 3", "change(n)", "--i", "i = 0", "change(i)"}) {
    EXPECT_FALSE(bounded("for (int i = 0; i < n; ++i) { " + body + "; }")) << body;
  }
  EXPECT_FALSE(bounded("for (int i = 0; i < v.x; ++i) { v.x += 1; }"));
  EXPECT_FALSE(bounded("for (int i = 0; i < limits.most; ++i) { limits.most = 2 * i; }"));
  EXPECT_FALSE(bounded("for (int i = 0; i < side(); ++i) {}"));
  EXPECT_FALSE(bounded("for (int i = 0; i < n; ++i, ++n) {}"));
  EXPECT_TRUE(bounded("++n; for (int i = 0; i < n; ++i) { v.x += 1; } ++n;"));
}

TEST_F(Loops, WhileAndDoAreNot) {
  EXPECT_FALSE(bounded("while (true) break;"));
  EXPECT_FALSE(bounded("int k = 0; while (k < 9) ++k;"));
  EXPECT_FALSE(bounded("int k = 0; do { ++k; } while (k < 9);"));
}

TEST_F(Loops, NestedLoopsAreJudgedEach) {
  EXPECT_TRUE(bounded("for (int i = 0; i < n; ++i) for (int j = 0; j < i; ++j) x += 1.0;"));
  EXPECT_FALSE(bounded("for (int i = 0; i < n; ++i) for (int j = 0; j < i; ++i) x += 1.0;"));
}

TEST_F(Loops, ErrorInTheLibraryWarningElsewhereAtItsLine) {
  const std::string module =
      "float f(float x) {\n  x += 1.0f;\n  while (x < 9.0f) {\n    x *= 2.0f;\n  }\n  return x;\n}\n";
  const std::string text =
      "loop without a bound: write for (int i = 0; i < LIMIT; ++i), with a limit that the loop does not "
      "modify, and say "
      "so where it is reached";
  const std::string inside = tree.file("library/relief/m.glsl", module);
  const auto failed = check(inside, options);
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.diagnostics().front().failure, Failure::kFailed);
  EXPECT_EQ(tree.relative(to_string(failed.diagnostics().front())),
            "library/relief/m.glsl:3: error: " + text);

  const auto passed = check(tree.file("librarian/m.glsl", module), options);
  ASSERT_TRUE(passed);
  ASSERT_EQ(passed->source.warnings.size(), 1u);
  EXPECT_EQ(tree.relative(to_string(passed->source.warnings.front())),
            "librarian/m.glsl:3: warning: " + text);

  const auto user = build(tree.file("a.frag", "#include <gnomon/relief/m.glsl>\nvoid main() {}\n"), options);
  ASSERT_FALSE(user);
  EXPECT_EQ(tree.relative(to_string(user.diagnostics().front())),
            "library/relief/m.glsl:3: error: " + text + "\n  included from a.frag:1");
}

}  // namespace
}  // namespace gnomon::compiler
