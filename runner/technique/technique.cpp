// SPDX-License-Identifier: MIT
#include "technique/technique.h"

#include <algorithm>

namespace gnomon::technique {

const std::vector<Technique>& techniques() {
  static const std::vector<Technique> table = {
      {"multilevel", "programs/multilevel.frag", "exact hard shadow over a pyramid of patch maxima"},
      {"multilevel_literal", "programs/multilevel_literal.frag",
       "the papers' own text with its errors, to see what they do", Bounds::kLiteralExtrema, false},
      {"brute_force", "programs/brute_force.frag", "exact hard shadow, every patch under the ray"},
      {"cascaded_shadow_maps", "programs/cascaded_shadow_maps.frag",
       "what engines use: the mesh as the sun sees it, in up to four maps", Bounds::kCascades, false},
      {"reference", "", "the double-precision oracle, no GL"},
  };
  return table;
}

const Technique* find_technique(const std::string& name) {
  const auto& table = techniques();
  const auto it =
      std::find_if(table.begin(), table.end(), [&](const Technique& t) { return t.name == name; });
  return it == table.end() ? nullptr : &*it;
}

}  // namespace gnomon::technique
