// SPDX-License-Identifier: MIT
// As walk.cpp, for the papers' own text: texels of H_q and blocks of H_ext.
#include <fmt/format.h>

#include <cmath>

#include "trace/walk.h"

namespace gnomon::trace {
namespace {

class LiteralStory {
 public:
  LiteralStory(const PixelModules& modules, const Question& question, std::vector<Visit> visits, int cause)
      : modules_(modules),
        map_(modules.literal_map()),
        visits_(std::move(visits)),
        cause_(cause),
        track_(modules.gnomon_literal_track(map_, question.receiver, question.to_sun, modules.q())),
        current_(glm::floor(track_.start)) {
    // The receiver's own texel is left without a look (erratum e).
    leave(track_.start, current_, 1);
  }

  Result<std::vector<Step>> tell() {
    std::vector<Step> steps;
    for (at_ = 0; at_ < visits_.size(); ++at_) {
      const Visit& visit = visits_[at_];
      const int level = visit.level > 0 ? visit.level : modules_.q();
      const glm::ivec2 block = current_ >> (level - modules_.q());
      if (visit.level > 0 && visit.index != block) return retold_wrongly(at_ + 1);
      steps.push_back(look(block, level));
      if (visit.level == 0 && visit.index != middle_patch_) return retold_wrongly(at_ + 1);
    }
    return steps;
  }

  [[nodiscard]] double start_height() const { return track_.height; }

 private:
  /// From `entry` through the block at `low` to the next texel.
  void leave(glm::vec2 entry, glm::ivec2 low, int side) {
    const Modules::GnomonTransit transit = modules_.gnomon_transit(entry, low, side, track_.direction);
    entry_ = entry + track_.direction * transit.t;
    current_ = modules_.gnomon_transit_next(transit, entry_, current_, low, side, track_.direction);
  }

  [[nodiscard]] glm::vec2 exit_of(glm::ivec2 low, int side) const {
    return entry_ + track_.direction * modules_.gnomon_transit(entry_, low, side, track_.direction).t;
  }

  Step look(glm::ivec2 block, int level) {
    const int side = 1 << (level - modules_.q());
    const glm::ivec2 low = block * side;
    const glm::vec2 exit_point = exit_of(low, side);
    const glm::vec2 middle = (entry_ + exit_point) * 0.5F;
    middle_patch_ = modules_.gnomon_receiver_at(middle.x, middle.y, 0).patch_index;
    Step step = along(exit_point);
    step.number = static_cast<int>(at_) + 1;
    step.level = visits_[at_].level;
    step.index = block;
    const int seen =
        modules_.gnomon_literal_look(map_, track_, entry_, exit_point, block, level, modules_.q());
    if (step.level > 0) {
      tell_block(seen, block, step);
    } else {
      tell_texel(seen, middle, step);
    }
    if (seen == GNOMON_LITERAL_PASS) {
      leave(entry_, low, side);
      step.reason += onward(step.level);
    }
    return step;
  }

  [[nodiscard]] Step along(glm::vec2 exit_point) const {
    Step step;
    for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
      const glm::dvec2 way = glm::dvec2(end == 0 ? entry_ : exit_point) - glm::dvec2(track_.start);
      step.t[end] = glm::length(way);
      step.distance[end] = glm::length(way * glm::dvec2(map_.spacing));
      step.ray[end] = ray_height(step.distance[end]);
    }
    return step;
  }

  [[nodiscard]] double ray_height(double distance) const {
    const glm::dvec3 sun(track_.to_sun);
    return double{track_.height} + distance * sun.z / std::hypot(sun.x, sun.y);
  }

  void tell_block(int seen, glm::ivec2 block, Step& step) const {
    const glm::vec2 extrema = modules_.gnomon_host_literal_extrema(block, step.level);
    step.highest = extrema.x;
    step.lowest = extrema.y;
    if (seen == GNOMON_LITERAL_MINIMUM) {
      step.decision = Decision::kLowest;
      step.reason =
          fmt::format("hides: h_min lies {:.6g} m above the ray at its exit", *step.lowest - step.ray[1]);
    } else if (seen == GNOMON_LITERAL_DESCEND) {
      step.decision = Decision::kDescends;
      step.reason =
          fmt::format("descends: h_max lies {:.6g} m above the ray at its exit", *step.highest - step.ray[1]);
    } else {
      step.decision = Decision::kSkips;
      step.reason =
          fmt::format("skips: h_max lies {:.6g} m below the ray at its exit", step.ray[1] - *step.highest);
    }
  }

  void tell_texel(int seen, glm::vec2 middle, Step& step) const {
    const float height = modules_.gnomon_literal_height(middle, modules_.q());
    const double above = double{height} - (step.ray[0] + step.ray[1]) / 2;
    if (!modules_.gnomon_is_sample(height)) {
      step.decision = Decision::kHole;
      step.reason = "passes: the patch has no surface";
      return;
    }
    step.surface = {height, height};
    step.decision = seen == GNOMON_LITERAL_SURFACE ? Decision::kHides : Decision::kPasses;
    step.reason = step.decision == Decision::kHides
                      ? fmt::format("hides: the sample in the middle lies {:.6g} m above the ray", above)
                      : fmt::format("passes: the sample in the middle lies {:.6g} m below the ray", -above);
  }

  [[nodiscard]] std::string onward(int level) const {
    if (at_ + 1 == visits_.size()) return cause_ == GNOMON_CAUSE_LEFT_MAP ? "; the ray leaves the map" : "";
    const int next = visits_[at_ + 1].level;
    return next > level ? fmt::format("; goes on from level {}, the coarsest", next) : "";
  }

  const PixelModules& modules_;
  Modules::GnomonMap map_;
  std::vector<Visit> visits_;
  int cause_;
  Modules::GnomonTrack track_;
  glm::ivec2 current_;
  glm::ivec2 middle_patch_{};  ///< where the papers' one sample of a texel lies (erratum f)
  glm::vec2 entry_{};
  std::size_t at_ = 0;
};

}  // namespace

Result<Walk> observe_literal_walk(const PixelModules& modules, const Question& question) {
  const Modules::GnomonMap map = modules.literal_map();
  Walk walk{.step_limit = modules.step_limit()};
  const Recorder recorder(modules);
  const Modules::GnomonShadow answer = recorder.gnomon_multilevel_literal(
      map, question.receiver, question.to_sun, modules.q(), walk.step_limit);
  walk.shadow = answer.shadow;
  walk.count = answer.steps;
  walk.cause = answer.cause;
  if (modules.gnomon_shadow_without_ray(question.to_sun).cause != GNOMON_CAUSE_UNDECIDED) return walk;
  const Recorder set_up(modules);
  static_cast<void>(set_up.gnomon_literal_track(map, question.receiver, question.to_sun, modules.q()));
  LiteralStory story(modules, question, visits_of(recorder.calls(), set_up.calls().size()), answer.cause);
  return told(std::move(walk), story);
}

}  // namespace gnomon::trace
