// SPDX-License-Identifier: MIT
#include "declarations.h"

#include <fmt/format.h>
#include <glslang/Include/PoolAlloc.h>

#include <map>
#include <string_view>
#include <vector>

#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// Goes through the global declarations, one after the other.
class GlobalScope {
 public:
  explicit GlobalScope(const std::vector<Token>& tokens) : tokens_(tokens) {}

  std::optional<Message> find_collision() {
    while (at_ < tokens_.size() && !collision_) declaration();
    return collision_;
  }

  // Of each name its first declaration.
  std::map<std::string_view, int> read_lines() {
    while (at_ < tokens_.size()) {
      declaration();
      collision_.reset();
    }
    return lines_;
  }

 private:
  [[nodiscard]] bool sees(std::string_view text) const {
    return at_ < tokens_.size() && tokens_[at_].is(text);
  }

  // From an opening to behind its closing one.
  void skip_group() {
    int depth = 0;
    for (; at_ < tokens_.size(); ++at_) {
      const Token& token = tokens_[at_];
      if (token.is("(") || token.is("[") || token.is("{")) ++depth;
      if ((token.is(")") || token.is("]") || token.is("}")) && --depth == 0) break;
    }
    ++at_;
  }

  // Of "= value", up to the comma or semicolon behind it.
  void skip_initializer() {
    while (at_ < tokens_.size() && !sees(",") && !sees(";")) {
      if (sees("(") || sees("[") || sees("{")) {
        skip_group();
      } else {
        ++at_;
      }
    }
  }

  void declare(const Token& name, bool is_uniform) {
    if (name.is("uniform")) return;  // "layout(std140) uniform;" declares nothing
    const auto [known, is_new] = lines_.emplace(name.text, name.line);
    if (is_uniform && !is_new)
      collision_ = Message{
          name.line, fmt::format("'{}': redefinition: another global declaration has this name", name.text),
          known->second};
  }

  // Up to its ; or behind the body of its function.
  void declaration() {
    bool is_uniform = false;
    bool is_struct = false;
    bool has_block = false;
    const Token* word = nullptr;  // the last one, which is the name where a declarator ends
    while (at_ < tokens_.size() && !collision_) {
      const Token& token = tokens_[at_];
      if (token.is("#")) return skip_line();
      if (token.is("=") || token.is(",") || token.is(";")) {
        if (word != nullptr) declare(*word, is_uniform && !has_block);
        word = nullptr;
        if (token.is("=")) skip_initializer();
        if (sees(";")) {
          ++at_;
          return;
        }
        if (sees(",")) ++at_;
      } else if (token.is("{")) {
        if (word == nullptr && !is_struct) return skip_group();  // a function
        if (word != nullptr) declare(*word, false);
        has_block = !is_struct;
        block(has_block);
        word = nullptr;
      } else if (token.is("(") || token.is("[")) {
        // Of a layout or array, which leave the name as it is, or the parameters of a function.
        if (token.is("(")) word = nullptr;
        skip_group();
      } else if (token.is("}") || token.is(")") || token.is("]")) {
        ++at_;
        return;
      } else {
        is_uniform = is_uniform || token.is("uniform");
        is_struct = is_struct || token.is("struct");
        if (is_identifier(token.text)) word = &token;
        ++at_;
      }
    }
  }

  void skip_line() {
    const int line = tokens_[at_].line;
    while (at_ < tokens_.size() && tokens_[at_].line == line) ++at_;
  }

  // Members of a block without an instance name are global.
  void block(bool is_block) {
    const size_t begin = at_;
    skip_group();
    if (!is_block || !sees(";")) return;
    const Token* word = nullptr;
    for (size_t i = begin; i < at_; ++i) {
      const Token& token = tokens_[i];
      if ((token.is(",") || token.is(";")) && word != nullptr) declare(*word, false);
      if (token.is(",") || token.is(";")) word = nullptr;
      if (is_identifier(token.text)) word = &token;
    }
  }

  const std::vector<Token>& tokens_;
  size_t at_ = 0;
  std::map<std::string_view, int> lines_;
  std::optional<Message> collision_;
};

}  // namespace

std::optional<Message> find_uniform_collision(const std::string& text) {
  const std::vector<Token> tokens = tokenize(text);
  return GlobalScope(tokens).find_collision();
}

int DeclarationLines::of(const std::string& name) {
  if (lines_.empty()) {
    // Whoever asks may be walking a tree, which goes on growing in its own memory.
    glslang::TPoolAllocator* const in_use = &glslang::GetThreadPoolAllocator();
    const std::string preprocessed = preprocess(text_, stage_, target_);
    glslang::SetThreadPoolAllocator(in_use);
    const std::vector<Token> tokens = tokenize(preprocessed);
    for (const auto& [declared, line] : GlobalScope(tokens).read_lines())
      lines_.emplace(std::string(declared), line);
  }
  const auto found = lines_.find(name);
  return found != lines_.end() ? found->second : line_of_word(text_, name);
}

}  // namespace gnomon::compiler
