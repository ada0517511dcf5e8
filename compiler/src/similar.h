// SPDX-License-Identifier: MIT
// What somebody may have meant who mistyped a word.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace gnomon::compiler {

/// The one of `words` that differs least from `word`, by at most a quarter of its letters: a letter that is
/// missing, wrong, one too many, or exchanged with its neighbour. Empty where none does; equal words do not
/// count.
[[nodiscard]] std::string similar_word(std::string_view word, std::span<const std::string_view> words);

/// The same among the words of a text.
[[nodiscard]] std::string similar_word(std::string_view word, std::string_view text);

}  // namespace gnomon::compiler
