// SPDX-License-Identifier: MIT
// Numbers and layouts as options write them.
#pragma once

#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

#include "gnomon/diagnostic.h"
#include "terrain/raw_layout.h"

namespace gnomon::cli {

/// The finite number that the whole text is, whatever the user's locale; absent where it is none.
template <class Number>
[[nodiscard]] std::optional<Number> number_in(const std::string& text) {
  Number number{};
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  if (!(stream >> number) || !stream.eof() || !std::isfinite(static_cast<double>(number)))
    return std::nullopt;
  return number;
}

/// WxH,TYPE[,little|big][,skip=BYTES], the last two in any order. Fails with what is wrong with the text.
[[nodiscard]] Result<terrain::RawLayout> raw_layout_in(const std::string& text);

}  // namespace gnomon::cli
