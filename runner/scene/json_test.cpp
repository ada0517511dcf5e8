// SPDX-License-Identifier: MIT
#include "scene/json.h"

#include <gtest/gtest.h>

namespace gnomon::scene::json {
namespace {

std::string first_error(std::string_view text) {
  const Parsed parsed = parse(text, "s.json");
  return parsed.diagnostics.empty() ? "" : to_string(parsed.diagnostics.front());
}

TEST(Json, KnowsWhereEveryValueAndKeyStands) {
  const Parsed parsed =
      parse("{\n  \"a\": [1, 2.5,\n    true],\n  \"b\\u0063\" : { \"d\": \"x\" } }", "s.json");
  ASSERT_TRUE(parsed.root && parsed.diagnostics.empty());
  const Value& root = *parsed.root;
  EXPECT_EQ(root.place, (Place{0, 1, 1}));
  EXPECT_EQ(root.object()[0].place, (Place{0, 2, 3}));
  EXPECT_EQ(root.find("a")->place, (Place{0, 2, 8}));
  EXPECT_EQ(root.find("a")->array()[0].place, (Place{0, 2, 9}));
  EXPECT_EQ(root.find("a")->array()[1].place, (Place{0, 2, 12}));
  EXPECT_EQ(root.find("a")->array()[2].place, (Place{0, 3, 5}));
  EXPECT_EQ(root.object()[1].place, (Place{0, 4, 3}));
  ASSERT_TRUE(root.find("bc"));
  EXPECT_EQ(root.find("bc")->find("d")->place, (Place{0, 4, 22}));
}

TEST(Json, NumbersKeepTheirKindAndTheirShortestForm) {
  EXPECT_EQ(dump(*parse("[1, 1.0, -0.1, 1e3, 18446744073709551615]", "").root),
            "[1,1.0,-0.1,1000.0,1.8446744073709552e+19]");
}

TEST(Json, SyntaxErrorsNameTheTokenAndItsPlace) {
  EXPECT_EQ(first_error("{\n  \"a\": 1,\n}"),
            "s.json:3:1: error: invalid JSON: a comma before the closing '}'");
  EXPECT_EQ(first_error("[1, 2,]"), "s.json:1:7: error: invalid JSON: a comma before the closing ']'");
  EXPECT_EQ(first_error("{\"a\": 1 \"b\": 2}"),
            "s.json:1:9: error: invalid JSON: unexpected string literal; expected '}'");
  EXPECT_EQ(first_error("{\"a\" 12}"),
            "s.json:1:6: error: invalid JSON: unexpected number literal; expected ':'");
  EXPECT_EQ(first_error("[1,,2]"),
            "s.json:1:4: error: invalid JSON: unexpected ','; expected '[', '{', or a literal");
  EXPECT_EQ(first_error("// hello\n{}"),
            "s.json:1:1: error: invalid JSON: comments are not allowed; use \"description\"");
  EXPECT_EQ(
      first_error("{'a': 1}"),
      "s.json:1:2: error: invalid JSON: this is neither a string in double quotes, a number, true, false nor "
      "null; expected string literal");
  EXPECT_EQ(first_error("[01]"), "s.json:1:3: error: invalid JSON: unexpected number literal; expected ']'");
  EXPECT_EQ(first_error("[1.]"), "s.json:1:4: error: invalid JSON: expected digit after '.'");
  EXPECT_EQ(first_error("{} {}"), "s.json:1:4: error: invalid JSON: unexpected '{'; expected end of input");
}

TEST(Json, NumbersThatOverflowAreErrors) {
  EXPECT_EQ(first_error("[1, -1e999]"),
            "s.json:1:5: error: invalid JSON: this number is too large for a double (above 1.8e308)");
}

TEST(Json, TruncatedTextIsSaidToEndTooEarly) {
  EXPECT_EQ(first_error("{\"a\": [1, 2"),
            "s.json:1:12: error: the file ends too early: a string, '}' or ']' is missing (2 still open)");
  EXPECT_EQ(first_error("{\"a\": \"bc"),
            "s.json:1:10: error: the file ends too early: a string, '}' or ']' is missing (1 still open)");
}

TEST(Json, RefusesWhatIsNoPlainUtf8Text) {
  EXPECT_EQ(first_error(""), "s.json:1:1: error: the file is empty; expected a JSON object: { ... }");
  EXPECT_EQ(first_error(" \n"), "s.json:1:1: error: the file is empty; expected a JSON object: { ... }");
  EXPECT_EQ(first_error("\xEF\xBB\xBF{}"),
            "s.json:1:1: error: the file starts with a byte order mark; save it as UTF-8 without one");
  EXPECT_EQ(first_error(std::string("{}\0{", 4)),
            "s.json:1:3: error: invalid JSON: a NUL byte; expected UTF-8 text");
  EXPECT_EQ(first_error("[\"a\xFF\"]"), "s.json:1:4: error: invalid JSON: ill-formed UTF-8 byte");
}

TEST(Json, RepeatedKeysAreNamedAndTheFirstValueIsKept) {
  const Parsed parsed = parse("{\"a\": 1,\n \"\\u0061\": {\"b\": 2}, \"c\": 3}", "s.json");
  ASSERT_TRUE(parsed.root);
  ASSERT_EQ(parsed.diagnostics.size(), 1U);
  EXPECT_EQ(to_string(parsed.diagnostics[0]),
            "s.json:2:2: error: repeated key \"a\" (first on line 1): keep one of the two");
  EXPECT_EQ(dump(*parsed.root), "{\"a\":1,\"c\":3}");
}

TEST(Json, DeepNestingIsAnErrorAndNoStackOverflow) {
  EXPECT_EQ(first_error(std::string(100000, '[')), "s.json:1:65: error: nested deeper than 64 levels");
  EXPECT_EQ(first_error(std::string(64, '[') + std::string(64, ']')), "");
}

TEST(Json, MessagesCutNoCharacterInTwo) {
  EXPECT_EQ(shortened("aé", 2), "a…");
  EXPECT_EQ(shortened("aé", 3), "aé");
}

TEST(Json, PointersAreEscaped) {
  EXPECT_EQ(child("/x", "a/b~c"), "/x/a~1b~0c");
}

}  // namespace
}  // namespace gnomon::scene::json
