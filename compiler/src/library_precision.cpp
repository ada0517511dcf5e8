// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "precisions.h"
#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// "precision mediump float;"
struct Statement {
  std::string_view precision;
  std::string_view type;
};

// What is known of a line of the text.
struct Line {
  std::string_view text;
  bool is_of_library = false;
  bool is_of_user = false;              // neither of the library nor added for the target
  bool may_begin = true;                // a declaration: none is open
  bool names_host = false;              // it has the name of a host function
  std::vector<Statement> statements{};  // of the user, that end here
};

std::vector<Line> cut(std::string_view rest, const Assembled& assembled) {
  std::vector<Line> lines;
  for (const LineOrigin& origin : assembled.origins) {
    const size_t length = std::min(rest.find('\n'), rest.size());
    const bool in_library = assembled.inclusions[static_cast<size_t>(origin.inclusion)].in_library;
    lines.push_back({rest.substr(0, length), origin.line > 0 && in_library, origin.line > 0 && !in_library});
    rest.remove_prefix(std::min(length + 1, rest.size()));
  }
  return lines;
}

// Goes through the text and notes where declarations end, outside of all braces.
class Declarations {
 public:
  explicit Declarations(std::vector<Line>& lines) : lines_(lines) {}

  void read(const std::vector<Token>& tokens) {
    for (size_t at = 0; at < tokens.size();) {
      const bool is_directive = tokens[at].first && tokens[at].is("#");
      const int line = tokens[at].line;
      mark_up_to(line);
      if (is_directive) directive(at + 1 < tokens.size() ? tokens[at + 1] : tokens[at]);
      while (at < tokens.size() && (!is_directive || tokens[at].line == line)) {
        if (!is_directive) {
          if (tokens[at].first && tokens[at].is("#")) break;
          token(tokens[at]);
        }
        ++at;
      }
    }
    mark_up_to(static_cast<int>(lines_.size()) + 1);
  }

 private:
  [[nodiscard]] bool is_closed() const { return depth_ == 0 && statement_.empty(); }

  // A line takes what holds at its beginning.
  void mark_up_to(int line) {
    for (; marked_ <= line && marked_ <= static_cast<int>(lines_.size()); ++marked_)
      lines_[static_cast<size_t>(marked_ - 1)].may_begin = is_closed();
  }

  // Each branch of a conditional begins where the first did.
  void directive(const Token& name) {
    if (name.text.starts_with("if")) {
      depths_.push_back(depth_);
    } else if (!depths_.empty() && (name.is("else") || name.is("elif"))) {
      depth_ = depths_.back();
    } else if (!depths_.empty() && name.is("endif")) {
      depths_.pop_back();
    }
  }

  void token(const Token& token) {
    mark_up_to(token.line);
    Line& line = lines_[static_cast<size_t>(token.line - 1)];
    line.names_host = line.names_host || token.text.starts_with("gnomon_host_");
    if (token.is("{")) ++depth_;
    if (token.is("}") && depth_ > 0) --depth_;
    if (token.is(";") && depth_ == 0 && statement_.size() == 3 && statement_[0] == "precision" &&
        line.is_of_user)
      line.statements.push_back({statement_[1], statement_[2]});
    statement_.push_back(token.text);
    if (token.is(";") || token.is("{") || token.is("}")) statement_.clear();
  }

  std::vector<Line>& lines_;
  std::vector<std::string_view> statement_;  // its words so far
  std::vector<int> depths_;                  // of braces, where each open conditional began
  int depth_ = 0;
  int marked_ = 1;
};

std::string macro_of(std::string_view type) {
  return "GNOMON_PRECISION_" + std::string(type);
}

class Rewriter {
 public:
  Rewriter(const std::vector<Line>& lines, std::set<std::string_view> types)
      : lines_(lines), types_(std::move(types)) {}

  void rewrite(Assembled& assembled) {
    const std::vector<LineOrigin> origins = std::exchange(assembled.origins, {});
    for (size_t i = 0; i < lines_.size(); ++i) {
      const Line& line = lines_[i];
      if (line.may_begin) switch_to(line.is_of_library || line.names_host);
      emit(line.text, origins[i]);
      if (i == 0) {
        for (const std::string_view type : types_) emit("#define " + macro_of(type) + " highp", {});
      }
      for (const Statement& statement : line.statements) {
        emit("#undef " + macro_of(statement.type), {});
        emit("#define " + macro_of(statement.type) + " " + std::string(statement.precision), {});
      }
    }
    // What is appended stands for the library's functions too.
    switch_to(true);
    assembled.text = std::move(text_);
    assembled.origins = std::move(origins_);
  }

 private:
  void emit(std::string_view line, LineOrigin origin) {
    text_.append(line).append("\n");
    origins_.push_back(origin);
  }

  void switch_to(bool precise) {
    if (precise == is_precise_) return;
    is_precise_ = precise;
    std::string line;
    for (const std::string_view type : types_)
      line += "precision " + (precise ? "highp" : macro_of(type)) + " " + std::string(type) + "; ";
    emit(trim(line), {});
  }

  const std::vector<Line>& lines_;
  std::set<std::string_view> types_;  // that the user gives a precision
  std::string text_;
  std::vector<LineOrigin> origins_;
  bool is_precise_ = false;
};

}  // namespace

void keep_library_precise(Assembled& assembled) {
  const std::string before = assembled.text;  // the lines lie in it
  const std::string code = blank_comments(before);
  std::vector<Line> lines = cut(before, assembled);
  Declarations(lines).read(tokenize(code));
  std::set<std::string_view> types;
  for (const Line& line : lines) {
    for (const Statement& statement : line.statements) types.insert(statement.type);
  }
  if (types.empty()) return;
  Rewriter(lines, std::move(types)).rewrite(assembled);
}

}  // namespace gnomon::compiler
