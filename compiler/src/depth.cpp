// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "excess.h"
#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// Each comma makes the tree of an expression one deeper, like an operator: see excess.cpp.
constexpr int kMostCommas = 4000;

// The linker of glslang and the validator of SPIR-V compare them all with each other.
constexpr size_t kMostFunctions = 2000;
constexpr size_t kMostCalls = 5000;
constexpr int kMostCases = 1000;  // of a function

// glslang looks for each constant of SPIR-V among all that it has made, of numbers and of what they make.
constexpr size_t kMostDifferentNumbers = 10000;
constexpr size_t kMostNumbers = 30000;

bool is_word(const Token& token) {
  return is_identifier(token.text);
}

// Before a parenthesis these make no call, before a name no declaration.
bool is_statement_word(const Token& token) {
  constexpr std::array<std::string_view, 8> words = {"return", "else",  "do",     "case",
                                                     "if",     "while", "switch", "for"};
  return std::ranges::find(words, token.text) != words.end();
}

// Tells the comma that is an operator from those between arguments, declared names and initializers.
class CommaCounter {
 public:
  // Whether there are too many with this token.
  bool add(const Token& token) {
    if (is_word(token) && is_name_of_declaration()) open_.front().separates = true;
    if (token.is("(")) {
      open_.push_back({.separates = is_call()});
    } else if (token.is("[")) {
      open_.push_back({});
    } else if (token.is("{") && is_initializer()) {
      open_.push_back({.separates = true, .is_initializer = true});
    } else if (token.is(";") || token.is("{") || (token.is("}") && !open_.back().is_initializer)) {
      open_.assign(1, {});
    } else if ((token.is(")") || token.is("]") || token.is("}")) && open_.size() > 1) {
      open_.pop_back();
    } else if (token.is(",") && !open_.back().separates) {
      ++open_.back().commas;
    }
    last_ = token;
    return open_.back().commas > kMostCommas;
  }

 private:
  struct Level {
    int commas = 0;
    bool separates = false;
    bool is_initializer = false;
  };

  // "float a" and "float[2] a" begin declarations.
  [[nodiscard]] bool is_name_of_declaration() const {
    return open_.size() == 1 && ((is_word(last_) && !is_statement_word(last_)) || last_.is("]"));
  }
  // "f(" and "float[](".
  [[nodiscard]] bool is_call() const {
    return (is_word(last_) && !is_statement_word(last_)) || last_.is("]");
  }
  [[nodiscard]] bool is_initializer() const {
    return last_.is("=") || (open_.back().is_initializer && (last_.is("{") || last_.is(",")));
  }

  std::vector<Level> open_{Level{}};
  Token last_{};
};

// Functions with a body, which calls which, and their cases.
class CallCounter {
 public:
  std::optional<Message> add(const Token& token) {
    if (token.is("{") && depth_++ == 0 && last_.is(")")) begin_function();
    if (token.is("case") && ++cases_ > kMostCases)
      return Message{token.line,
                     fmt::format("a function has more than {} cases: read a table, or split it", kMostCases)};
    if (token.is("}") && depth_ > 0) --depth_;
    if (token.is("(") && is_word(last_)) {
      if (depth_ == 0) {
        name_ = last_.text;
      } else if (const auto callee = functions_.find(last_.text); callee != functions_.end()) {
        calls_.emplace(function_, callee->first);
      }
    }
    last_ = token;
    if (functions_.size() > kMostFunctions) return too_many("functions", kMostFunctions, token.line);
    if (calls_.size() > kMostCalls)
      return too_many("calls of one function by another", kMostCalls, token.line);
    return std::nullopt;
  }

 private:
  // Overloads count each, callers of the same name once.
  void begin_function() {
    function_ = name_;
    cases_ = 0;
    functions_.emplace(name_, last_.line);
  }

  static Message too_many(std::string_view what, size_t limit, int line) {
    return {line, fmt::format("the shader has more than {} {} up to this line: include less", limit, what)};
  }

  std::multimap<std::string_view, int> functions_;
  std::set<std::pair<std::string_view, std::string_view>> calls_;
  std::string_view name_;      // the last one before a parenthesis, outside of functions
  std::string_view function_;  // that is open
  Token last_{};
  int depth_ = 0;
  int cases_ = 0;  // of the open function
};

std::optional<Message> find_too_many_numbers(const std::vector<Token>& tokens) {
  std::unordered_set<std::string_view> different;
  size_t all = 0;
  for (const Token& token : tokens) {
    if (token.text.front() < '0' || token.text.front() > '9') continue;
    different.insert(token.text);
    ++all;
    if (all > kMostNumbers || different.size() > kMostDifferentNumbers)
      return Message{token.line,
                     fmt::format("the shader has more than {} numbers, or {} different ones, up to this "
                                 "line: put large tables into a texture or buffer",
                                 kMostNumbers, kMostDifferentNumbers)};
  }
  return std::nullopt;
}

}  // namespace

std::optional<Message> find_depth(const std::string& preprocessed, bool becomes_spirv) {
  const std::vector<Token> tokens = tokenize(preprocessed);
  if (auto large = find_large_structure(tokens)) return large;
  if (becomes_spirv) {
    if (auto many = find_too_many_numbers(tokens)) return many;
  }
  CommaCounter commas;
  CallCounter calls;
  for (const Token& token : tokens) {
    if (auto many = calls.add(token)) return many;
    if (commas.add(token))
      return Message{token.line, fmt::format("an expression of more than {} parts with commas between them: "
                                             "split it into several statements",
                                             kMostCommas)};
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
