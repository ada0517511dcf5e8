// SPDX-License-Identifier: MIT
#include "trace/pixel_modules.h"

#include <algorithm>

#include "technique/pyramid.h"
#include "technique/tiles.h"
#include "terrain/level.h"

namespace gnomon::trace {

PixelModules::PixelModules(const terrain::HeightMap& base, int q)
    : base_(base), level_(terrain::level(base, q)), q_(q) {}

float PixelModules::gnomon_host_height(glm::ivec2 sample, int q) const {
  const terrain::HeightMap& map = q == q_ ? level_ : base_;  // H_ext is built of H_0 at every level
  return map.at(glm::clamp(sample.y, 0, map.height - 1), glm::clamp(sample.x, 0, map.width - 1));
}

float PixelModules::gnomon_host_extrema(glm::ivec2 block, int level, int q) const {
  const Block key{level, block.x, block.y};
  const auto found = extrema_.find(key);
  if (found != extrema_.end()) return found->second;
  const float highest =
      level == 1 ? gnomon_extrema_of_patches(block, q) : gnomon_extrema_of_blocks(block, level, q);
  return extrema_.emplace(key, highest).first->second;
}

glm::vec2 PixelModules::gnomon_host_literal_extrema(glm::ivec2 block, int level) const {
  const Block key{level, block.x, block.y};
  const auto found = literal_extrema_.find(key);
  if (found != literal_extrema_.end()) return found->second;
  const glm::vec2 extrema =
      level == 1 ? gnomon_literal_extrema_of_texels(block) : gnomon_literal_extrema_of_blocks(block, level);
  return literal_extrema_.emplace(key, extrema).first->second;
}

Modules::GnomonMap PixelModules::map() const {
  return {.size = {level_.width, level_.height},
          .domain = glm::vec2(level_.domain_width, level_.domain_height),
          .spacing = glm::vec2(level_.spacing_x, level_.spacing_y),
          .highest = *std::max_element(level_.samples.begin(), level_.samples.end()),
          .top_level = technique::block_levels({level_.width + 1, level_.height + 1})};
}

Modules::GnomonMap PixelModules::literal_map() const {
  GnomonMap literal = map();
  literal.top_level = std::max(terrain::coarsest_level(base_.width, base_.height) - 1, 0);
  return literal;
}

int PixelModules::step_limit() const {
  return technique::step_limit({level_.width, level_.height});
}

std::vector<Visit> visits_of(const std::vector<HostCall>& calls, std::size_t set_up) {
  std::vector<Visit> visits;
  for (std::size_t i = set_up; i < calls.size(); ++i) {
    if (calls[i].kind == HostCall::Kind::kHeight) i = std::min(i + 3, calls.size() - 1);
    visits.push_back({calls[i].index, calls[i].level});
  }
  return visits;
}

}  // namespace gnomon::trace
