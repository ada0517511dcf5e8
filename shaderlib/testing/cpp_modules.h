// SPDX-License-Identifier: MIT
// The relief modules as C++ functions, with host functions over a height map in memory: the very code that
// the GPU runs, for unit tests. Everything is local to the file that includes this.
#ifndef GNOMON_TESTING_CPP_MODULES_H
#define GNOMON_TESTING_CPP_MODULES_H

#include <algorithm>
#include <cstddef>
#include <glm/glm.hpp>
#include <map>
#include <utility>
#include <vector>

#include "terrain/height_map.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace {
namespace glsl {

using namespace glm;

#include <gnomon/baseline/brute_force.glsl>
#include <gnomon/host/decode.glsl>
#include <gnomon/relief/extrema.glsl>
#include <gnomon/relief/multilevel.glsl>
#include <gnomon/relief/shade.glsl>

/// What the host functions read; set by HostMap.
struct HostState {
  const gnomon::terrain::HeightMap* map = nullptr;
  std::map<int, std::pair<glm::ivec2, std::vector<float>>> extrema;  // by level: size and values
};
inline HostState& host() {
  static HostState state;
  return state;
}

float gnomon_host_height(ivec2 sample_index, int q) {
  const auto& map = *host().map;
  return map.at(clamp(sample_index.y, 0, map.height - 1), clamp(sample_index.x, 0, map.width - 1));
}

float gnomon_host_extrema(ivec2 block, int level, int q) {
  const auto& [size, values] = host().extrema.at(level);
  const ivec2 inside = clamp(block, ivec2(0), size - 1);
  return values[static_cast<std::size_t>(inside.y) * static_cast<std::size_t>(size.x) +
                static_cast<std::size_t>(inside.x)];
}

/// Makes `map` the height map that the host functions answer from, with its block maxima built by the
/// modules.
inline GnomonMap use_map(const gnomon::terrain::HeightMap& map, int top_level = 7) {
  host() = {&map, {}};
  ivec2 size((map.width + 2) / 2, (map.height + 2) / 2);
  float highest = *std::max_element(map.samples.begin(), map.samples.end());
  for (int level = 1; level <= top_level; ++level, size = (size + 1) / 2) {
    std::vector<float> values;
    for (int y = 0; y < size.y; ++y) {
      for (int x = 0; x < size.x; ++x) {
        values.push_back(level == 1 ? gnomon_extrema_of_patches(ivec2(x, y), 0)
                                    : gnomon_extrema_of_blocks(ivec2(x, y), level, 0));
      }
    }
    host().extrema[level] = {size, std::move(values)};
  }
  GnomonMap result;
  result.size = ivec2(map.width, map.height);
  result.domain = vec2(map.domain_width, map.domain_height);
  result.spacing = vec2(map.spacing_x, map.spacing_y);
  result.highest = highest;
  result.top_level = top_level;
  return result;
}

/// The bound that a runner hands in.
inline int step_limit(const GnomonMap& map) {
  return 8 * (map.size.x + map.size.y);
}

}  // namespace glsl
}  // namespace

#pragma GCC diagnostic pop

#endif
