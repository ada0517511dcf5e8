// SPDX-License-Identifier: MIT
// The modules decide; what they visit is observed at their host. Between two visits the modules' own
// functions for leaving a patch or block tell where the ray is, and every visit is held against that.
#include "trace/walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::trace {
namespace {

using Cursor = Modules::GnomonCursor;
using Ray = Modules::GnomonRay;
using Crossing = Modules::GnomonCrossing;

class Story {
 public:
  Story(const PixelModules& modules, const Question& question, std::vector<Visit> visits, int cause)
      : modules_(modules),
        map_(modules.map()),
        question_(question),
        visits_(std::move(visits)),
        cause_(cause),
        ray_(modules.gnomon_ray(map_, question.receiver, question.to_sun, modules.q())),
        t_above_(modules.gnomon_t_above(map_, ray_)) {
    begin_side();
  }

  Result<std::vector<Step>> tell() {
    for (at_ = 0; at_ < visits_.size(); ++at_) {
      if (cursor_.cause != GNOMON_CAUSE_UNDECIDED) {
        ray_ = modules_.gnomon_ray_other_side(ray_);
        other_side_ = true;
        begin_side();
      }
      if (visit().index != cursor_.patch_index >> visit().level) return retold_wrongly(at_ + 1);
      Step step = visit().level > 0 ? block() : patch();
      step.number = static_cast<int>(at_) + 1;
      step.level = visit().level;
      step.index = visit().index;
      step.other_side = other_side_;
      steps_.push_back(std::move(step));
    }
    if (ended_differently()) return retold_wrongly(visits_.size());
    return std::move(steps_);
  }

  [[nodiscard]] double start_height() const { return double{ray_.base} + double{ray_.height}; }

 private:
  [[nodiscard]] const Visit& visit() const { return visits_[at_]; }
  [[nodiscard]] const Visit* next_visit() const {
    return at_ + 1 < visits_.size() ? &visits_[at_ + 1] : nullptr;
  }

  /// Both sides of an edge are walked from the receiver on; how far the near walk goes, it says itself.
  void begin_side() {
    cursor_ = modules_.gnomon_cursor_at_start(ray_);
    clearance_ = -question_.receiver.height;
    near_end_ = at_ + static_cast<std::size_t>(
                          modules_.gnomon_near_walk(ray_, question_.receiver.height, modules_.q()).steps);
  }

  [[nodiscard]] bool ended_differently() const {
    const bool hidden = !steps_.empty() && steps_.back().decision == Decision::kHides;
    return hidden ? cause_ != GNOMON_CAUSE_SURFACE : cause_ != cursor_.cause;
  }

  [[nodiscard]] double ray_height(double t) const { return start_height() + double{ray_.rise} * t; }

  /// Where the ray is in a patch or block that it leaves at `exits`.
  [[nodiscard]] Step along(glm::vec2 exits) const {
    const double metres = std::hypot(double{ray_.direction.x} * double{map_.spacing.x},
                                     double{ray_.direction.y} * double{map_.spacing.y});
    Step step;
    step.t = {cursor_.t, std::max(cursor_.t, std::min({exits.x, exits.y, ray_.t_end}))};
    step.distance = {step.t[0] * metres, step.t[1] * metres};
    step.ray = {ray_height(step.t[0]), ray_height(step.t[1])};
    return step;
  }

  Step block() {
    const int level = visit().level;
    const glm::ivec2 low = visit().index << level;
    const glm::vec2 exits = modules_.gnomon_ray_exits(ray_, low, level);
    const float highest = modules_.gnomon_host_extrema(visit().index, level, modules_.q());
    Step step = along(exits);
    if (modules_.gnomon_is_sample(highest)) step.highest = highest;
    const double above = double{highest} - step.ray[0];
    if (descends(highest)) {
      step.decision = Decision::kDescends;
      step.reason =
          fmt::format("descends: the block's highest sample lies {:.6g} m above the ray at its entry", above);
      return step;
    }
    step.decision = Decision::kSkips;
    step.reason = step.highest
                      ? fmt::format("skips: the whole block lies {:.6g} m or more below the ray", -above)
                      : "skips: the block has no sample";
    cursor_ = modules_.gnomon_leave_block(ray_, cursor_, low, level, exits, t_above_);
    step.reason += onward(level);
    return step;
  }

  /// Whether the walk looked closer: its next visit is in the same block, one level below. The last visit of
  /// a walk that was cut off has none, and is compared here.
  [[nodiscard]] bool descends(float highest) const {
    if (const Visit* next = next_visit())
      return next->level == visit().level - 1 && next->index == cursor_.patch_index >> next->level;
    return cause_ == GNOMON_CAUSE_UNDECIDED && highest - ray_.base > ray_.height + ray_.rise * cursor_.t;
  }

  Step patch() {
    const bool near = at_ < near_end_;
    const glm::vec2 exits = modules_.gnomon_ray_exits(ray_, visit().index, 0);
    const Crossing crossing = modules_.gnomon_crossing(ray_, visit().index, cursor_.t, modules_.q());
    const float crossed = modules_.gnomon_crossed(ray_, cursor_.t, exits);
    const float clearance =
        near ? clearance_ : modules_.gnomon_far_clearance(ray_, crossing, cursor_.t, cursor_.after_hole);
    Step step = along(exits);
    if (!crossing.hole) {
      step.surface = {
          step.ray[0] + double{clearance},
          step.ray[1] + double{modules_.gnomon_clearance_at(crossing, clearance, std::max(crossed, 0.0F))}};
    }
    const double most = highest_clearance(crossing, clearance, crossed);
    if (!next_visit() && cause_ == GNOMON_CAUSE_SURFACE) {
      step.decision = Decision::kHides;
      step.reason = fmt::format("hides: the surface rises {:.6g} m above the ray", most);
      return step;
    }
    tell_passing(crossing, crossed, most, step);
    if (near) clearance_ = modules_.gnomon_carried_clearance(crossing, clearance_, crossed);
    // Close to the receiver a ray cannot be known to be above everything.
    cursor_ = modules_.gnomon_leave_patch(ray_, cursor_, crossing, exits, near ? GNOMON_NEVER : t_above_);
    step.reason += onward(0);
    return step;
  }

  /// Of the surface above the ray within the patch, metres.
  static double highest_clearance(const Crossing& crossing, float clearance, float crossed) {
    const double a = crossing.curvature;
    const double b = crossing.slope;
    const double length = std::max(double{crossed}, 0.0);
    const auto at = [&](double s) { return double{clearance} + s * (b + a * s); };
    const double top = a < 0 ? std::clamp(-b / (2 * a), 0.0, length) : 0.0;
    return std::max({at(0), at(top), at(length)});
  }

  static void tell_passing(const Crossing& crossing, float crossed, double most, Step& step) {
    if (crossing.hole) {
      step.decision = Decision::kHole;
      step.reason = "passes: the patch has no surface";
    } else if (crossed <= 0) {
      step.decision = Decision::kTouches;
      step.reason = "passes: the ray only touches the patch";
    } else if (most < 0) {
      step.reason = fmt::format("passes: the surface stays {:.6g} m or more below the ray", -most);
    } else if (step.t[0] == 0) {
      step.reason = "passes: from the receiver on, the surface does not rise above the ray";
    } else {
      step.reason = "passes: the surface touches the ray and does not rise above it";
    }
  }

  /// What comes next, or how the walk ended.
  [[nodiscard]] std::string onward(int level) const {
    if (cursor_.cause == GNOMON_CAUSE_LEFT_MAP)
      return next_visit() ? "; the ray leaves the map; again on the other side of the edges it runs along"
                          : "; the ray leaves the map";
    if (cursor_.cause == GNOMON_CAUSE_ABOVE_ALL)
      return next_visit() ? "; above every sample; again on the other side of the edges the ray runs along"
                          : fmt::format("; the ray rises above the highest sample, {:.6g} m", map_.highest);
    const Visit* next = next_visit();
    return next && next->level > level ? fmt::format("; climbs to level {}", next->level) : "";
  }

  const PixelModules& modules_;
  Modules::GnomonMap map_;
  const Question& question_;
  std::vector<Visit> visits_;
  int cause_;
  Ray ray_;
  float t_above_;
  Cursor cursor_{};
  float clearance_ = 0;
  std::size_t at_ = 0;
  std::size_t near_end_ = 0;
  bool other_side_ = false;
  std::vector<Step> steps_{};
};

}  // namespace

Diagnostic retold_wrongly(std::size_t step) {
  return {
      .message = fmt::format("step {} of the walk is not the one that was expected there; this is a fault "
                             "of 'gnomon trace', please report it with this scene",
                             step),
      .failure = Failure::kFailed};
}

Result<Walk> observe_walk(const PixelModules& modules, const Question& question, const std::string& method) {
  const Modules::GnomonMap map = modules.map();
  const Recorder set_up(modules);
  const Modules::GnomonShadow without_ray = modules.gnomon_shadow_without_ray(question.to_sun);
  Walk walk{.step_limit = modules.step_limit()};
  const Recorder recorder(modules);
  const Modules::GnomonShadow answer =
      method == "brute_force"
          ? recorder.gnomon_brute_force(map, question.receiver, question.to_sun, modules.q(), walk.step_limit)
          : recorder.gnomon_multilevel(map, question.receiver, question.to_sun, modules.q(), walk.step_limit);
  walk.shadow = answer.shadow;
  walk.count = answer.steps;
  walk.cause = answer.cause;
  if (without_ray.cause != GNOMON_CAUSE_UNDECIDED) return walk;
  static_cast<void>(set_up.gnomon_ray(map, question.receiver, question.to_sun, modules.q()));
  Story story(modules, question, visits_of(recorder.calls(), set_up.calls().size()), answer.cause);
  return told(std::move(walk), story);
}

}  // namespace gnomon::trace
