// SPDX-License-Identifier: MIT
#include "excess.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <vector>

#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// A million tokens are some seconds of glslang; the largest shader of the library has about 2,000.
constexpr double kMostTokens = 1e6;
// glslang and SPIRV-Cross walk a tree by recursion; 20,000 overflow a stack of 8 MiB.
constexpr double kMostOperators = 4000;
// Macros that use each other, one in another: both this check and glslang expand them by recursion.
constexpr int kDeepestMacros = 500;
// Macros that are called in each other's arguments, which glslang expands again at each level.
constexpr int kDeepestCalls = 1000;

// Doubles, because chains of macros overflow every integer.
struct Size {
  double tokens = 0;
  double operators = 0;
  int depth = 0;           // of macros in each other
  double parentheses = 0;  // that open
};

struct Macro {
  std::vector<std::string_view> parameters;
  std::vector<Token> body;
  bool takes_arguments = false;
};

bool is_operator(const Token& token) {
  constexpr std::string_view characters = "+-*/%<>=!&|^~?:.[";
  return token.text.size() == 1 && characters.find(token.text.front()) != characters.npos;
}

// What each macro becomes once everything in it is expanded.
class Macros {
 public:
  void define(std::string_view name, Macro macro) { macros_.emplace(name, std::move(macro)); }

  // A token that stands alone, with its macro expanded; arguments not counted.
  Size size_of(const Token& token) {
    const Expansion& expansion = expand(token.text);
    return {expansion.size.tokens, expansion.size.operators + (is_operator(token) ? 1 : 0),
            expansion.size.depth, expansion.size.parentheses + (token.is("(") ? 1 : 0)};
  }

  [[nodiscard]] bool takes_arguments(const Token& token) const {
    const auto [first, last] = macros_.equal_range(token.text);
    return std::any_of(first, last, [](const auto& macro) { return macro.second.takes_arguments; });
  }

  // How often the most used parameter of the macro appears in what it becomes; 1 for other words.
  double copies_of_argument(const Token& token) { return expand(token.text).copies; }

 private:
  struct Expansion {
    Size size{1, 0};
    double copies = 1;
  };

  const Expansion& expand(std::string_view name) {
    static const Expansion itself;
    const auto [first, last] = macros_.equal_range(name);
    if (first == last) return itself;
    // Entered before it is computed: within its own expansion a macro is not expanded.
    const auto [known, is_new] = expansions_.emplace(name, Expansion{});
    if (!is_new) return known->second;
    if (open_ > kDeepestMacros) return known->second = {{1, 0, kDeepestMacros + 1}, 1};
    ++open_;
    Expansion most;
    for (auto macro = first; macro != last; ++macro) {
      const Expansion expansion = expand(macro->second);
      most.size.tokens = std::max(most.size.tokens, expansion.size.tokens);
      most.size.operators = std::max(most.size.operators, expansion.size.operators);
      most.size.depth = std::max(most.size.depth, expansion.size.depth);
      most.size.parentheses = std::max(most.size.parentheses, expansion.size.parentheses);
      most.copies = std::max(most.copies, expansion.copies);
    }
    --open_;
    return known->second = most;
  }

  Expansion expand(const Macro& macro) {
    std::map<std::string_view, double> uses;
    Expansion expansion{{0, 0, 1}, 1};
    std::vector<double> copies{1};  // of what stands in each of the open parentheses
    double next = 1;                // of what a parenthesis that follows opens
    for (const Token& token : macro.body) {
      const double here = copies.back();
      const bool is_parameter = std::ranges::find(macro.parameters, token.text) != macro.parameters.end();
      if (is_parameter) {
        uses[token.text] += here;
      } else {
        const Size size = size_of(token);
        expansion.size.tokens += here * size.tokens;
        expansion.size.operators += here * size.operators;
        expansion.size.depth = std::max(expansion.size.depth, size.depth + 1);
        expansion.size.parentheses += here * size.parentheses;
      }
      if (token.is("(")) copies.push_back(here * next);
      if (token.is(")") && copies.size() > 1) copies.pop_back();
      next = is_parameter ? 1 : copies_of_argument(token);
    }
    for (const auto& [parameter, count] : uses) expansion.copies = std::max(expansion.copies, count);
    return expansion;
  }

  std::multimap<std::string_view, Macro> macros_;
  std::map<std::string_view, Expansion> expansions_;
  int open_ = 0;  // macros that are being expanded
};

// The tokens of one directive, or of the lines between two.
struct Section {
  size_t begin;
  size_t end;
  bool is_directive;
};

std::vector<Section> split(const std::vector<Token>& tokens) {
  std::vector<Section> sections;
  for (size_t at = 0; at < tokens.size();) {
    const bool is_directive = tokens[at].first && tokens[at].is("#");
    size_t end = at + 1;
    while (end < tokens.size() && !(tokens[end].first && (is_directive || tokens[end].is("#")))) ++end;
    sections.push_back({at, end, is_directive});
    at = end;
  }
  return sections;
}

// "# define NAME body" or "# define NAME(a, b) body".
void read_define(const std::vector<Token>& tokens, Section section, Macros& macros) {
  if (section.end - section.begin < 3 || !tokens[section.begin + 1].is("define")) return;
  const std::string_view name = tokens[section.begin + 2].text;
  size_t at = section.begin + 3;
  Macro macro;
  // A blank before the parenthesis makes it a part of the body.
  macro.takes_arguments =
      at < section.end && tokens[at].is("(") && tokens[at].text.data() == name.data() + name.size();
  for (bool open = macro.takes_arguments; open && at < section.end; ++at) {
    if (is_identifier(tokens[at].text)) macro.parameters.push_back(tokens[at].text);
    open = !tokens[at].is(")");
  }
  macro.body.assign(tokens.begin() + static_cast<std::ptrdiff_t>(at),
                    tokens.begin() + static_cast<std::ptrdiff_t>(section.end));
  macros.define(name, std::move(macro));
}

class Counter {
 public:
  // The preprocessor walks a condition by recursion, through each parenthesis too.
  Counter(Macros& macros, bool is_condition) : macros_(macros), is_condition_(is_condition) {}

  // Says what is too much with the token, if anything.
  std::optional<Message> add(const Token& token) {
    const Size size = macros_.size_of(token);
    const double copies = open_.back().copies;
    tokens_ += copies * size.tokens;
    const double operators = copies * (size.operators + (is_condition_ ? size.parentheses : 0));
    open_.back().operators += operators;
    operators_ += operators;
    written_ += 1;
    if (size.depth > kDeepestMacros)
      return Message{token.line, fmt::format("the macro {} uses others more than {} deep, one in another: "
                                             "write functions",
                                             token.text, kDeepestMacros)};
    if (tokens_ > kMostTokens) return Message{token.line, too_long()};
    if (operators_ > kMostOperators)
      return Message{token.line, fmt::format("an expression of more than {:.0f} operators, macros expanded: "
                                             "split it into several statements, or write a loop",
                                             kMostOperators)};
    if (!is_condition_) step(token);
    if (calls_ > kDeepestCalls)
      return Message{token.line, fmt::format("macros are called more than {} deep, one in the arguments of "
                                             "another: write functions",
                                             kDeepestCalls)};
    return std::nullopt;
  }

 private:
  // Whoever wrote a table has to hear something else than whoever wrote macros.
  [[nodiscard]] std::string too_long() const {
    if (written_ > kMostTokens / 2)
      return fmt::format(
          "the shader has more than {:.0f} words, numbers and signs up to this line: put "
          "large tables into a texture or buffer",
          kMostTokens);
    return fmt::format(
        "macros expand to more than {:.0f} tokens up to this line: a macro that uses another "
        "twice doubles it; write a function",
        kMostTokens);
  }

  // A parenthesis, with the operators since its last comma.
  struct Level {
    double copies = 1;
    double operators = 0;
    bool is_macro_call = false;
  };

  void step(const Token& token) {
    if (token.is("(")) {
      open_.push_back({open_.back().copies * next_copies_, 0, opens_call_});
      calls_ += opens_call_ ? 1 : 0;
    } else if (token.is(")")) {
      operators_ -= open_.back().operators;
      open_.back().operators = 0;
      calls_ -= open_.back().is_macro_call ? 1 : 0;
      if (open_.size() > 1) open_.pop_back();
    } else if (token.is(",")) {
      operators_ -= open_.back().operators;
      open_.back().operators = 0;
    } else if (token.is(";") || token.is("{") || token.is("}")) {
      open_.assign(1, {});
      operators_ = 0;
      calls_ = 0;
    }
    opens_call_ = macros_.takes_arguments(token);
    next_copies_ = macros_.copies_of_argument(token);
  }

  Macros& macros_;
  bool is_condition_;
  bool opens_call_ = false;  // a parenthesis that follows
  int calls_ = 0;            // of macros, that are open
  double tokens_ = 0;
  double written_ = 0;    // those of the text itself
  double operators_ = 0;  // of all open levels
  double next_copies_ = 1;
  std::vector<Level> open_{Level{}};
};

}  // namespace

std::optional<Message> find_excess(const std::string& text) {
  const std::string code = blank_comments(text);
  const std::vector<Token> tokens = tokenize(code);
  const std::vector<Section> sections = split(tokens);
  Macros macros;
  for (const Section& section : sections) {
    if (section.is_directive) read_define(tokens, section, macros);
  }
  Counter code_counter(macros, false);
  for (const Section& section : sections) {
    const auto is_condition = [&] {
      return section.end - section.begin > 2 &&
             (tokens[section.begin + 1].is("if") || tokens[section.begin + 1].is("elif"));
    };
    if (section.is_directive && !is_condition()) continue;
    Counter condition(macros, true);
    Counter& counter = section.is_directive ? condition : code_counter;
    for (size_t at = section.begin; at < section.end; ++at) {
      if (auto excess = counter.add(tokens[at])) return excess;
    }
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
