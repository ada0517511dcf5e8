// SPDX-License-Identifier: MIT
#include "oracle/horizon_search.h"

#include <algorithm>
#include <cmath>

namespace gnomon::oracle {
namespace {

// Whether the track runs along the edges between patches.
bool runs_on_edge(const Axis& axis) {
  return axis.rate == 0 && axis.origin == std::floor(axis.origin);
}

double fraction_of_patch(const Axis& axis, int patch, double distance) {
  return std::clamp(axis.position(distance) - (patch - 1), 0.0, 1.0);
}

// The patch of the axis at which the track enters the next block, having left this one at `exit`.
int patch_after_block(const Axis& axis, int patch, int block, double exit, bool crosses) {
  const int first = block * BlockMaxima::kSize;
  const int last = first + BlockMaxima::kSize - 1;
  if (crosses) return axis.rate > 0 ? last + 1 : first - 1;
  const int reached = static_cast<int>(std::floor(axis.position(exit))) + 1;
  return axis.rate < 0 ? std::clamp(reached, first, patch) : std::clamp(reached, patch, last);
}

}  // namespace

HorizonSearch::HorizonSearch(const Surface& surface, const Receiver& receiver, GroundDirection towards_sun,
                             const BlockMaxima* blocks)
    : surface_(surface),
      blocks_(blocks),
      x_(receiver.column, surface.domain_width, towards_sun.east / surface.spacing_x),
      y_(receiver.row, surface.domain_height, -towards_sun.north / surface.spacing_y),  // rows run southward
      column_(x_.first_patch()),
      row_(y_.first_patch()),
      end_(std::min(x_.domain_exit, y_.domain_exit)),
      rise_(-receiver.height),
      on_ground_(receiver.height == 0) {
  const std::optional<PatchIndex> ground = ground_patch(surface, x_.origin, y_.origin);
  has_ground_ = ground.has_value();
  if (!ground) return;
  datum_ = Patch(surface, ground->column, ground->row, 0.0).north_west;
  eye_ = Patch(surface, ground->column, ground->row, datum_)
             .height(fraction_of_patch(x_, ground->column, 0), fraction_of_patch(y_, ground->row, 0)) +
         receiver.height;
}

double HorizonSearch::run() {
  if (!has_ground_) return best_;
  if (end_ > 0 && rise_ > 0) return std::numeric_limits<double>::infinity();  // under the ground
  while (distance_ < end_) {
    if (!blocks_ || near_receiver()) {
      walk_patch();
    } else if (cannot_beat_best(blocks_->highest(), end_)) {
      break;
    } else {
      walk_or_pass_block();
    }
  }
  return best_;
}

bool HorizonSearch::near_receiver() const {
  return distance_ * std::max(std::abs(x_.rate), std::abs(y_.rate)) <= 1;
}

// highest - eye <= best * d is linear in d, so it holds all the way when it holds at both ends.
bool HorizonSearch::cannot_beat_best(double highest, double exit) const {
  const double rise = highest - datum_ - eye_;
  return rise <= best_ * distance_ && rise <= best_ * exit;
}

void HorizonSearch::walk_or_pass_block() {
  const int size = BlockMaxima::kSize;
  const int block_column = column_ / size;
  const int block_row = row_ / size;
  const double exit_x = x_.exit(block_column * size, block_column * size + size - 1);
  const double exit_y = y_.exit(block_row * size, block_row * size + size - 1);
  const double exit = std::min({exit_x, exit_y, end_});
  if (cannot_beat_best(blocks_->highest(block_column, block_row), exit)) {
    column_ = patch_after_block(x_, column_, block_column, exit, exit_x == exit);
    row_ = patch_after_block(y_, row_, block_row, exit, exit_y == exit);
    distance_ = std::max(distance_, exit);
    return;
  }
  do {
    walk_patch();
  } while (distance_ < end_ && column_ / size == block_column && row_ / size == block_row);
}

void HorizonSearch::walk_patch() {
  const double exit_x = x_.exit(column_, column_);
  const double exit_y = y_.exit(row_, row_);
  const double exit = std::min({exit_x, exit_y, end_});
  if (exit > distance_) {
    look_at_patch(exit);
    distance_ = exit;
  }
  if (exit_x == exit) column_ += x_.rate > 0 ? 1 : -1;
  if (exit_y == exit) row_ += y_.rate > 0 ? 1 : -1;
}

// The patch beyond the edge that the track runs along; the current one where it runs along none.
PatchIndex HorizonSearch::patch_beside() const {
  return {column_ - (runs_on_edge(x_) ? 1 : 0), row_ - (runs_on_edge(y_) ? 1 : 0)};
}

// The candidates for H* in one patch: its exit (its entry was the exit of the patch before), and the point
// where the line of sight touches the surface. Where the surface is A d^2 + B d + C above the receiver, it
// touches at sqrt(C/A).
void HorizonSearch::look_at_patch(double exit) {
  PatchIndex at{column_, row_};
  Patch patch(surface_, at.column, at.row, datum_);
  if (!patch.is_whole()) {
    at = patch_beside();
    patch = Patch(surface_, at.column, at.row, datum_);
  }
  if (!patch.is_whole()) {
    after_hole_ = true;
    return;
  }
  const double x = fraction_of_patch(x_, at.column, distance_);
  const double y = fraction_of_patch(y_, at.row, distance_);
  const auto [linear, quadratic] = patch.profile(x, y, x_.rate, y_.rate);  // about the entry
  const double length = exit - distance_;

  if (distance_ == 0 && on_ground_) {
    // C is exactly 0: the slope is A d + B, and B is its limit at the receiver.
    const double slope_at_exit = linear + quadratic * length;
    best_ = std::max({best_, linear, slope_at_exit});
    rise_ = length * slope_at_exit;
    return;
  }

  if (after_hole_ || !near_receiver()) rise_ = patch.height(x, y) - eye_;
  if (after_hole_ && distance_ > 0) best_ = std::max(best_, rise_ / distance_);
  after_hole_ = false;
  const auto rise_after = [&](double s) { return rise_ + s * (linear + quadratic * s); };
  const double constant = rise_ - distance_ * (linear - quadratic * distance_);
  if (quadratic < 0 && constant < 0) {
    const double touch = std::sqrt(constant / quadratic);
    if (touch > distance_ && touch < exit) best_ = std::max(best_, rise_after(touch - distance_) / touch);
  }
  rise_ = rise_after(length);
  best_ = std::max(best_, rise_ / exit);
}

}  // namespace gnomon::oracle
