// SPDX-License-Identifier: MIT
// Where a view ray meets the surface, in double precision: the judge of what a camera sees.
#pragma once

#include <optional>

#include "oracle/oracle.h"

namespace gnomon::oracle {

struct ViewRay {
  double origin[3];     ///< metres: x east, y north of the domain's south-west corner, z up
  double direction[3];  ///< of any length
};

/// View rays against one surface, which has to outlive it.
class ViewTracer {
 public:
  explicit ViewTracer(const Surface& surface);

  /// The smallest t >= 0 at which origin + t * direction dives under the surface, which is seen from above;
  /// absent where it does not, and where it begins, or enters the domain, under it. Patches without a surface
  /// are passed; a sheet that begins above the ray, beyond one, is not seen. Exact in each bilinear patch;
  /// steps by integer index.
  [[nodiscard]] std::optional<double> first_hit(const ViewRay& ray) const;

 private:
  const Surface& surface_;
  double highest_;  ///< sample, metres
};

}  // namespace gnomon::oracle
