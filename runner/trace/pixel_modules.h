// SPDX-License-Identifier: MIT
// The shader modules as C++ for a single pixel: block maxima are computed where a ray asks for them. Internal
// to this folder.
#pragma once

#include <gnomon/modules.h>

#include <map>
#include <tuple>
#include <vector>

#include "terrain/height_map.h"

namespace gnomon::trace {

/// Over level q of a map, as a GPU host has it. The map has to outlive it.
class PixelModules : public Modules {
 public:
  PixelModules(const terrain::HeightMap& base, int q);

  float gnomon_host_height(glm::ivec2 sample, int q) const override;
  float gnomon_host_extrema(glm::ivec2 block, int level, int q) const override;
  glm::vec2 gnomon_host_literal_extrema(glm::ivec2 block, int level) const override;

  /// What a method over block maxima takes, and what multilevel_literal takes.
  [[nodiscard]] GnomonMap map() const;
  [[nodiscard]] GnomonMap literal_map() const;
  [[nodiscard]] int q() const { return q_; }
  /// Blocks and patches that a ray may visit on the GPU.
  [[nodiscard]] int step_limit() const;

 private:
  using Block = std::tuple<int, int, int>;  ///< level, column, row

  const terrain::HeightMap& base_;
  terrain::HeightMap level_;
  int q_;
  mutable std::map<Block, float> extrema_;
  mutable std::map<Block, glm::vec2> literal_extrema_;
};

/// A call of a host function.
struct HostCall {
  enum class Kind { kHeight, kExtrema, kLiteralExtrema };
  Kind kind;
  glm::ivec2 index;  ///< sample or block
  int level = 0;     ///< of a block
};

/// The same modules, keeping what they ask their host for: what a walk visits, seen without touching it.
class Recorder final : public Modules {
 public:
  explicit Recorder(const PixelModules& modules) : modules_(modules) {}

  float gnomon_host_height(glm::ivec2 sample, int q) const override {
    calls_.push_back({HostCall::Kind::kHeight, sample});
    return modules_.gnomon_host_height(sample, q);
  }
  float gnomon_host_extrema(glm::ivec2 block, int level, int q) const override {
    calls_.push_back({HostCall::Kind::kExtrema, block, level});
    return modules_.gnomon_host_extrema(block, level, q);
  }
  glm::vec2 gnomon_host_literal_extrema(glm::ivec2 block, int level) const override {
    calls_.push_back({HostCall::Kind::kLiteralExtrema, block, level});
    return modules_.gnomon_host_literal_extrema(block, level);
  }

  [[nodiscard]] const std::vector<HostCall>& calls() const { return calls_; }

 private:
  const PixelModules& modules_;
  mutable std::vector<HostCall> calls_;
};

/// A patch (level 0) or a block that a walk looked at.
struct Visit {
  glm::ivec2 index;
  int level = 0;
};

/// The visits of a walk whose first `set_up` calls prepared the ray: a patch is read by its four samples, the
/// south-eastern one, which gives it its index, last; a block by one call.
[[nodiscard]] std::vector<Visit> visits_of(const std::vector<HostCall>& calls, std::size_t set_up);

}  // namespace gnomon::trace
