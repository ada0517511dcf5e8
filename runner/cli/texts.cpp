// SPDX-License-Identifier: MIT
#include "cli/texts.h"

#include <algorithm>
#include <vector>

namespace gnomon::cli {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::istringstream stream(text + ',');  // a comma at the end is an empty part too
  std::vector<std::string> parts;
  for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
  return parts;
}

std::string known_types() {
  std::string known;
  for (const auto& [name, value] : terrain::kRawTypes)
    known += (known.empty() ? "" : ", ") + std::string(name);
  return known;
}

/// Takes what may follow the type: the byte order or skip=BYTES. False where the part is neither.
bool take_detail(const std::string& part, terrain::RawLayout& layout) {
  if (part == "little" || part == "big") {
    layout.big_endian = part == "big";
    return true;
  }
  if (!part.starts_with("skip=") || part.find('-') != std::string::npos) return false;
  const auto skip = number_in<std::uint64_t>(part.substr(5));
  layout.skip = skip.value_or(0);
  return skip.has_value();
}

}  // namespace

Result<terrain::RawLayout> raw_layout_in(const std::string& text) {
  const auto refused = [&](const std::string& why) {
    return Diagnostic{.message = "'" + text + "' is not WxH,TYPE[,little|big][,skip=BYTES]: " + why};
  };
  const std::vector<std::string> parts = parts_of(text);
  const std::size_t times = parts[0].find('x');
  if (times == std::string::npos || parts.size() < 2)
    return refused("the size and the type are needed, as in 1201x1201,int16");
  const auto width = number_in<int>(parts[0].substr(0, times));
  const auto height = number_in<int>(parts[0].substr(times + 1));
  if (!width || !height || std::min(*width, *height) < 1 || std::max(*width, *height) > 16384)
    return refused("each side has to be 1 to 16384");
  const std::optional<terrain::RawType> type = terrain::raw_type(parts[1]);
  if (!type) return refused("the type is one of " + known_types());
  terrain::RawLayout layout{.width = *width, .height = *height, .type = *type};
  for (std::size_t i = 2; i < parts.size(); ++i) {
    if (!take_detail(parts[i], layout))
      return refused("'" + parts[i] + "' is neither little, big nor skip=BYTES");
  }
  return layout;
}

}  // namespace gnomon::cli
