// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "phrase.h"
#include "text.h"

namespace gnomon::compiler {
namespace {

constexpr std::array<std::string_view, 26> kQualifiers = {
    "temp",          "global",    "const",   "in",        "out",       "inout",    "uniform",
    "buffer",        "shared",    "highp",   "mediump",   "lowp",      "flat",     "smooth",
    "noperspective", "centroid",  "precise", "invariant", "coherent",  "volatile", "restrict",
    "readonly",      "writeonly", "sample",  "patch",     "nonuniform"};

void skip_qualifiers(std::string_view& text) {
  for (;;) {
    std::string_view rest = trim(text);
    const std::string_view word = take_word(rest);
    if (rest.empty() || std::ranges::find(kQualifiers, word) == kQualifiers.end()) break;
    text = rest;
  }
  text = trim(text);
}

std::optional<int> take_number(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<size_t>(end - text.data()));
  return number;
}

bool take(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

std::string prefix_of(std::string_view scalar) {
  return scalar == "float" ? std::string() : std::string(scalar.substr(0, 1));
}

// "4-component vector of float" and "3X3 matrix of float".
std::optional<std::string> spell_composite(std::string_view text) {
  const auto first = take_number(text);
  if (!first) return std::nullopt;
  if (take(text, "-component vector of ")) {
    skip_qualifiers(text);
    return fmt::format("{}vec{}", prefix_of(text), *first);
  }
  if (!take(text, "X")) return std::nullopt;
  const auto second = take_number(text);
  if (!second || !take(text, " matrix of ")) return std::nullopt;
  skip_qualifiers(text);
  const std::string size =
      *first == *second ? fmt::format("{}", *first) : fmt::format("{}x{}", *first, *second);
  return fmt::format("{}mat{}", prefix_of(text), size);
}

}  // namespace

std::string spell_type(std::string_view type) {
  skip_qualifiers(type);
  std::string sizes;
  for (;;) {
    std::string_view rest = type;
    const bool unsized = take(rest, "unsized ");
    const auto size = take_number(rest);
    if (!size || !take(rest, "-element array of ")) break;
    sizes += unsized ? "[]" : fmt::format("[{}]", *size);
    type = rest;
    skip_qualifiers(type);
  }
  if (type.starts_with("structure{")) return "a structure" + sizes;
  return spell_composite(type).value_or(std::string(type)) + sizes;
}

}  // namespace gnomon::compiler
