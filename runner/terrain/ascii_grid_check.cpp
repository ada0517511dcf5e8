// SPDX-License-Identifier: MIT
#include "terrain/ascii_grid_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <fstream>
#include <string_view>

namespace gnomon::terrain {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_header_key(const std::string& word) {
  constexpr std::array<std::string_view, 10> kKeys{"ncols",     "nrows",       "xllcorner", "xllcenter",
                                                   "yllcorner", "yllcenter",   "cellsize",  "dx",
                                                   "dy",        "nodata_value"};
  return std::find(kKeys.begin(), kKeys.end(), lower(word)) != kKeys.end();
}

/// A decimal number, with a comma for a point as some programs write it, or one of the ways to say "none".
bool is_number(std::string word) {
  std::replace(word.begin(), word.end(), ',', '.');
  const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
  if (end == word.data() + word.size() && error != std::errc::invalid_argument) return true;
  const std::string plain = lower(word.substr(word.find_first_not_of("+-") == 1 ? 1 : 0));
  return plain == "1.#inf" || plain == "1.#ind" || plain == "1.#qnan";
}

}  // namespace

std::optional<std::string> ascii_grid_defect(const std::string& path, std::size_t count) {
  std::ifstream file(path, std::ios::binary);
  std::string word;
  while (file >> word && is_header_key(word)) file >> word;
  std::size_t found = 0;
  for (; file; file >> word, ++found) {
    if (!is_number(word))
      return fmt::format("'{}', after {} heights, is no number", word.substr(0, 40), found);
    if (found > count) break;
  }
  if (found == count) return std::nullopt;
  return fmt::format("its header says {} heights, the file holds {}{}", count,
                     found > count ? "more than " : "", std::min(found, count));
}

}  // namespace gnomon::terrain
