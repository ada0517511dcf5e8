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

// Doubles, because chains of macros overflow every integer.
struct Size {
  double tokens = 0;
  double operators = 0;
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
    return {expansion.size.tokens, expansion.size.operators + (is_operator(token) ? 1 : 0)};
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
    Expansion most;
    for (auto macro = first; macro != last; ++macro) {
      const Expansion expansion = expand(macro->second);
      most.size.tokens = std::max(most.size.tokens, expansion.size.tokens);
      most.size.operators = std::max(most.size.operators, expansion.size.operators);
      most.copies = std::max(most.copies, expansion.copies);
    }
    return known->second = most;
  }

  Expansion expand(const Macro& macro) {
    std::map<std::string_view, double> uses;
    Expansion expansion{{0, 0}, 1};
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
  explicit Counter(Macros& macros) : macros_(macros) {}

  // Says what is too much with the token, if anything.
  std::optional<Message> add(const Token& token) {
    const Size size = macros_.size_of(token);
    const double copies = open_.back().copies;
    tokens_ += copies * size.tokens;
    open_.back().operators += copies * size.operators;
    operators_ += copies * size.operators;
    if (tokens_ > kMostTokens)
      return Message{token.line, fmt::format("macros expand to more than {:.0f} tokens up to this line: a "
                                             "macro that uses another twice doubles it; write a function",
                                             kMostTokens)};
    if (operators_ > kMostOperators)
      return Message{token.line, fmt::format("an expression of more than {:.0f} operators, macros expanded: "
                                             "split it into several statements, or write a loop",
                                             kMostOperators)};
    step(token);
    return std::nullopt;
  }

 private:
  // A parenthesis, with the operators since its last comma.
  struct Level {
    double copies = 1;
    double operators = 0;
  };

  void step(const Token& token) {
    if (token.is("(")) {
      open_.push_back({open_.back().copies * next_copies_});
    } else if (token.is(")")) {
      operators_ -= open_.back().operators;
      open_.back().operators = 0;
      if (open_.size() > 1) open_.pop_back();
    } else if (token.is(",")) {
      operators_ -= open_.back().operators;
      open_.back().operators = 0;
    } else if (token.is(";") || token.is("{") || token.is("}")) {
      open_.assign(1, {});
      operators_ = 0;
    }
    next_copies_ = macros_.copies_of_argument(token);
  }

  Macros& macros_;
  double tokens_ = 0;
  double operators_ = 0;  // of all open levels
  double next_copies_ = 1;
  std::vector<Level> open_{Level{}};
};

}  // namespace

std::optional<Message> find_excess(const std::string& text) {
  const std::string code = blank_comments(text);
  const std::vector<Token> tokens = tokenize(code);
  if (auto large = find_large_structure(tokens)) return large;
  const std::vector<Section> sections = split(tokens);
  Macros macros;
  for (const Section& section : sections) {
    if (section.is_directive) read_define(tokens, section, macros);
  }
  Counter code_counter(macros);
  for (const Section& section : sections) {
    const auto is_condition = [&] {
      return section.end - section.begin > 2 &&
             (tokens[section.begin + 1].is("if") || tokens[section.begin + 1].is("elif"));
    };
    if (section.is_directive && !is_condition()) continue;
    Counter condition(macros);
    Counter& counter = section.is_directive ? condition : code_counter;
    for (size_t at = section.begin; at < section.end; ++at) {
      if (auto excess = counter.add(tokens[at])) return excess;
    }
  }
  return std::nullopt;
}

}  // namespace gnomon::compiler
