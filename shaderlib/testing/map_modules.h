// SPDX-License-Identifier: MIT
// The shader modules as C++ over a height map in memory: the very code that the GPU runs, for tests.
#ifndef GNOMON_TESTING_MAP_MODULES_H
#define GNOMON_TESTING_MAP_MODULES_H

#include <gnomon/modules.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "terrain/height_map.h"
#include "terrain/level.h"

namespace gnomon::modules {

/// The modules over one level of a height map, with its block maxima built by relief/extrema and the papers'
/// H_ext by relief/literal_extrema.
class MapModules final : public Modules {
 public:
  explicit MapModules(terrain::HeightMap heights, int top_level = 7) : heights_(std::move(heights)) {
    ivec2 size((heights_.width + 2) / 2, (heights_.height + 2) / 2);
    for (int level = 1; level <= top_level; ++level, size = (size + 1) / 2) {
      extrema_.push_back({size, {}});
      for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) extrema_.back().values.push_back(highest_of(ivec2(x, y), level));
      }
    }
    const int levels = terrain::coarsest_level(heights_.width, heights_.height) - 1;
    size = ivec2((heights_.width + 1) / 2, (heights_.height + 1) / 2);
    for (int level = 1; level <= levels; ++level, size = (size + 1) / 2) {
      literal_extrema_.push_back({size, {}});
      for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x)
          literal_extrema_.back().values.push_back(
              level == 1 ? gnomon_literal_extrema_of_texels(ivec2(x, y))
                         : gnomon_literal_extrema_of_blocks(ivec2(x, y), level));
      }
    }
    map_ = {.size = ivec2(heights_.width, heights_.height),
            .domain = vec2(heights_.domain_width, heights_.domain_height),
            .spacing = vec2(heights_.spacing_x, heights_.spacing_y),
            .highest = *std::max_element(heights_.samples.begin(), heights_.samples.end()),
            .top_level = top_level};
  }

  [[nodiscard]] float gnomon_host_height(ivec2 sample_index, int) const override {
    return heights_.at(clamp(sample_index.y, 0, heights_.height - 1),
                       clamp(sample_index.x, 0, heights_.width - 1));
  }

  [[nodiscard]] float gnomon_host_extrema(ivec2 block, int level, int) const override {
    return extrema_.at(static_cast<std::size_t>(level - 1)).at(block);
  }

  [[nodiscard]] vec2 gnomon_host_literal_extrema(ivec2 block, int level) const override {
    return literal_extrema_.at(static_cast<std::size_t>(level - 1)).at(block);
  }

  /// What the sun sees, where a test says it; else numbers without a meaning, the same on the GPU.
  std::function<float(ivec2, int)> light_nearness = [](ivec2 texel, int cascade) {
    return static_cast<float>((texel.x * 7 + texel.y * 13 + cascade * 29) & 63) / 64.0F;
  };
  [[nodiscard]] float gnomon_host_light_nearness(ivec2 texel, int cascade) const override {
    return light_nearness(texel, cascade);
  }

  /// Coarsest level of gnomon_host_literal_extrema, 0 where it has none.
  [[nodiscard]] int literal_top_level() const { return static_cast<int>(literal_extrema_.size()); }

  [[nodiscard]] const terrain::HeightMap& heights() const { return heights_; }

  /// What a shadow method takes.
  [[nodiscard]] const GnomonMap& map() const { return map_; }

  /// Steps that always suffice, which a runner hands in.
  [[nodiscard]] int step_limit() const { return 8 * (heights_.width + heights_.height); }

 private:
  template <class Value>
  struct Level {
    ivec2 size;
    std::vector<Value> values;

    [[nodiscard]] Value at(ivec2 block) const {
      const ivec2 inside = clamp(block, ivec2(0), size - 1);
      return values[static_cast<std::size_t>(inside.y) * static_cast<std::size_t>(size.x) +
                    static_cast<std::size_t>(inside.x)];
    }
  };

  [[nodiscard]] float highest_of(ivec2 block, int level) const {
    return level == 1 ? gnomon_extrema_of_patches(block, 0) : gnomon_extrema_of_blocks(block, level, 0);
  }

  terrain::HeightMap heights_;
  std::vector<Level<float>> extrema_;
  std::vector<Level<vec2>> literal_extrema_;
  GnomonMap map_{};
};

/// A map on which every sample is `height` metres high, 1 m apart.
[[nodiscard]] inline terrain::HeightMap flat_map(int width, int height, float metres = 5.0F) {
  const auto samples = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return {width, height, 1, 1, double(width), double(height), std::vector<float>(samples, metres)};
}

}  // namespace gnomon::modules

#endif
