// SPDX-License-Identifier: MIT
// What glslang says, said to a person who wrote the shader: in the words of GLSL, with what to do.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shader.h"

namespace gnomon::compiler {

/// Words for what is wrong with one text.
class Phrasing {
 public:
  /// `text`: what was compiled.
  explicit Phrasing(const std::string& text);

  /// `entry`: as in the log, "'x' : undeclared identifier "; `line`: where, 1-based in the text.
  [[nodiscard]] Message message(std::string_view entry, int line) const;

 private:
  struct Entry {
    std::string_view token;  // 'x', without its quotes; may be empty
    std::string_view reason;
    int line;
  };

  [[nodiscard]] std::string_view line(int number) const;
  [[nodiscard]] std::string_view line_before(int number) const;
  [[nodiscard]] int line_of_directive(const Entry& entry) const;
  [[nodiscard]] int earlier_declaration(std::string_view name, int before, bool is_function) const;
  [[nodiscard]] bool defines(std::string_view macro, std::string_view word) const;
  [[nodiscard]] std::string undeclared(const Entry& entry) const;
  [[nodiscard]] std::string no_overload(const Entry& entry) const;
  [[nodiscard]] std::string unexpected_character(const Entry& entry) const;
  [[nodiscard]] std::string text_of(const Entry& entry) const;

  std::string code_;                     // without comments
  std::vector<std::string_view> lines_;  // of the code
};

/// "vec4" for "const highp 4-component vector of float": a type as GLSL spells it, without qualifiers. What
/// has another form stays as it is.
[[nodiscard]] std::string spell_type(std::string_view type);

/// "syntax error, unexpected INT, expecting COMMA or SEMICOLON" in words. `line`: the code of its line, where
/// keywords keep their capitals and a name is looked for; `before`: the code before that line.
[[nodiscard]] std::string spell_syntax_error(std::string_view reason, std::string_view line,
                                             std::string_view before);

}  // namespace gnomon::compiler
