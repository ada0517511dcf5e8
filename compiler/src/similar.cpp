// SPDX-License-Identifier: MIT
#include "similar.h"

#include <algorithm>
#include <set>
#include <vector>

#include "text.h"
#include "tokens.h"

namespace gnomon::compiler {
namespace {

// The optimal string alignment distance, row by row.
size_t distance(std::string_view a, std::string_view b) {
  std::vector<size_t> before(b.size() + 1);
  std::vector<size_t> above(b.size() + 1);
  std::vector<size_t> row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    std::swap(before, above);
    std::swap(above, row);
  }
  return above[b.size()];
}

}  // namespace

std::string similar_word(std::string_view word, std::span<const std::string_view> words) {
  constexpr size_t longest = 64;  // the effort is the product of two lengths
  if (word.size() > longest) return {};
  std::string_view best;
  size_t least = word.size() / 4 + 1;
  for (const std::string_view candidate : words) {
    const size_t longer = std::max(candidate.size(), word.size());
    if (candidate == word || longer - std::min(candidate.size(), word.size()) >= least) continue;
    const size_t difference = distance(word, candidate);
    if (difference >= least) continue;
    least = difference;
    best = candidate;
  }
  return std::string(best);
}

std::string similar_word(std::string_view word, std::string_view text) {
  std::set<std::string_view> words;
  for (const Token& token : tokenize(text)) {
    if (is_identifier(token.text)) words.insert(token.text);
  }
  return similar_word(word, std::vector<std::string_view>(words.begin(), words.end()));
}

}  // namespace gnomon::compiler
