// SPDX-License-Identifier: MIT
// The search for H* along one ground track. Private to the oracle.
#pragma once

#include <limits>
#include <optional>

#include "oracle/block_maxima.h"
#include "oracle/oracle.h"
#include "oracle/patch.h"

namespace gnomon::oracle {

/// Walks the patches under the ground track of one receiver and keeps the steepest line of sight. Steps by
/// integer patch index, so it ends after at most width + height + 1 patches whatever the rounding does.
class HorizonSearch {
 public:
  /// The receiver must lie in the domain. `blocks` (may be null) belongs to `surface`; both must outlive the
  /// search.
  HorizonSearch(const Surface& surface, const Receiver& receiver, GroundDirection towards_sun,
                const BlockMaxima* blocks);

  /// H*; to be called once.
  [[nodiscard]] double run();

 private:
  void walk_or_pass_block();
  void walk_patch();
  void look_at_patch(double exit);
  [[nodiscard]] PatchIndex patch_beside() const;
  [[nodiscard]] bool near_receiver() const;
  [[nodiscard]] bool cannot_beat_best(double highest, double exit) const;

  const Surface& surface_;
  const BlockMaxima* blocks_;
  Axis x_;
  Axis y_;
  int column_;  // current patch
  int row_;
  double end_;           // where the track leaves the domain, metres of ground distance like the next
  double distance_ = 0;  // where the track enters the current patch
  // Heights count from a corner of the receiver's own patch: differences of nearby heights keep all their
  // digits, however high the terrain lies above zero.
  double datum_ = 0;
  double eye_ = 0;  // the receiver above the datum
  double rise_;     // the surface above the receiver at distance_; kept up to date only near the receiver
  bool on_ground_;
  bool has_ground_;          // there is a surface under the receiver
  bool after_hole_ = false;  // the patch before has no surface, so that the entry is a candidate too
  double best_ = -std::numeric_limits<double>::infinity();
};

}  // namespace gnomon::oracle
