// SPDX-License-Identifier: MIT
// How rows of the comparison of GPU and C++ are made: exact, or within a few ulp of the largest intermediate.
#ifndef GNOMON_TESTING_ROW_MAKERS_H
#define GNOMON_TESTING_ROW_MAKERS_H

#include <algorithm>
#include <cmath>
#include <limits>

#include "testing/gpu_rows.h"

namespace gnomon::modules {

// `make` gives the arguments as a tuple.
template <class R, class... P, class Make>
[[nodiscard]] Row exact(const char* name, R (Modules::*function)(P...) const, Make make) {
  return {.function = describe(name, function),
          .arguments = [make](RandomArguments& random) { return scalars_of(Given<P...>(make(random))); }};
}

// `largest` gives, for the modules and the same arguments, an answer that holds the largest intermediates.
template <class R, class... P, class Make, class Largest>
[[nodiscard]] Row within_4_ulp(const char* name, R (Modules::*function)(P...) const, Make make,
                               Largest largest) {
  Row row = exact(name, function, make);
  row.largest = [largest](const Modules& modules, std::span<const float> scalars) {
    const auto given = std::tuple_cat(std::tie(modules), take_tuple<Given<P...>>(scalars));
    return scalars_of(Answer<R, P...>(std::apply(largest, given)));
  };
  return row;
}

[[nodiscard]] inline Row deciding(Row row) {
  row.decides = true;
  return row;
}

// A magnitude by which only zeros of different sign pass: max(0, -0) may be either.
inline constexpr float kZeroOfEitherSign = std::numeric_limits<float>::min();

// The largest of the numbers that come up on the way to a bilinear height and to its slopes, in double.
// A compiler that sees gnomon_patch too may take slope + twist * y for a mix() of the slopes at both edges
// and distribute it, so the slopes at the far edges count.
class Bilinear {
 public:
  Bilinear(const Modules::GnomonPatch& p, dvec2 at)
      : largest_(largest_of({p.origin, p.slope.x, p.slope.y, p.twist, double{p.slope.x} + p.twist,
                             double{p.slope.y} + p.twist})),
        slope_(p.slope.x + p.twist * at.y, p.slope.y + p.twist * at.x),
        north_(p.origin + p.slope.x * at.x),
        height_(north_ + at.y * slope_.y) {}

  [[nodiscard]] float of_height(float above = 0) const {
    return largest_of({largest_, slope_.y, north_, height_, above, above + height_});
  }
  [[nodiscard]] float of_slope(const Modules::GnomonRay& ray) const {
    const dvec2 rise = slope_ * dvec2(ray.direction);
    return largest_of(
        {largest_, slope_.x, slope_.y, rise.x + rise.y, ray.rise, rise.x + rise.y - double{ray.rise}});
  }

 private:
  [[nodiscard]] static float largest_of(std::initializer_list<double> numbers) {
    double largest = 0;
    for (const double number : numbers) largest = std::max(largest, std::abs(number));
    return static_cast<float>(largest);
  }

  double largest_;
  dvec2 slope_;
  double north_;
  double height_;
};

}  // namespace gnomon::modules

#endif
