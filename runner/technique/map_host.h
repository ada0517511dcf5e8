// SPDX-License-Identifier: MIT
// The shader modules as C++ over a height map: what the runner computes without GL, it computes by them.
#pragma once

#include <gnomon/modules.h>

#include "terrain/height_map.h"

namespace gnomon::technique {

/// For the modules that ask for heights alone. The map has to outlive it.
class MapHost final : public Modules {
 public:
  explicit MapHost(const terrain::HeightMap& map) : map_(map) {}

  float gnomon_host_height(glm::ivec2 sample, int) const override {
    return map_.at(glm::clamp(sample.y, 0, map_.height - 1), glm::clamp(sample.x, 0, map_.width - 1));
  }
  float gnomon_host_extrema(glm::ivec2, int, int) const override { return 0; }
  glm::vec2 gnomon_host_literal_extrema(glm::ivec2, int) const override { return {}; }

  /// What the view and shading modules take.
  [[nodiscard]] GnomonMap map() const {
    return {.size = {map_.width, map_.height},
            .domain = glm::vec2(map_.domain_width, map_.domain_height),
            .spacing = glm::vec2(map_.spacing_x, map_.spacing_y),
            .highest = 0,
            .top_level = 1};
  }

 private:
  const terrain::HeightMap& map_;
};

}  // namespace gnomon::technique
