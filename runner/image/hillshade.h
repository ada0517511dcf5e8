// SPDX-License-Identifier: MIT
// Hill-shaded relief with its cast shadows, for people.
#pragma once

#include <vector>

#include "image/image.h"

namespace gnomon::image {

/// Relief as a map maker would draw it: tinted by height, shaded from the sun's azimuth, darkened and cooled
/// where the shadow falls. `heights` (metres) and `k_shadow` (1 lit, less in shadow) have width * height
/// values, row 0 = north; a height that is NaN is no surface, and painted grey; spacing is in metres a pixel.
/// Gentle terrain is shaded as if steeper and a low sun as if higher, so that slopes can be told apart; the
/// cast shadows are those given.
[[nodiscard]] Picture hillshade(const std::vector<float>& heights, int width, int height, double spacing_x,
                                double spacing_y, const std::vector<float>& k_shadow, double sun_azimuth_deg,
                                double sun_elevation_deg);

}  // namespace gnomon::image
