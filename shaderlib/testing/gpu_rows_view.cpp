// SPDX-License-Identifier: MIT
// Rows of the modules in view/ and shading/.
#include "testing/row_makers.h"

namespace gnomon::modules {
namespace {

using M = Modules;
using Random = RandomArguments;

// The largest number behind where a view ray meets the surface: a quotient of a difference of heights, each
// as large as `height`, by the rate at which ray and surface close in.
float largest_of_hit(float hit, double rate, double height, double closing) {
  return static_cast<float>(std::max(std::abs(double{hit}), std::abs(rate) * height / std::abs(closing)));
}

// The same for an answer in `texels` a parameter; `rise` in metres a parameter.
M::GnomonHit largest_of_hit(const M& modules, const M::GnomonHit& hit, dvec2 texels, double rise,
                            double height, int q) {
  M::GnomonHit largest{};
  if (hit.cause != GNOMON_VIEW_SURFACE) return largest;
  const M::GnomonReceiver foot = modules.gnomon_receiver_at(hit.at.x, hit.at.y, 0);
  const M::GnomonPatch p = modules.gnomon_patch(foot.patch_index, 0, q);
  const double east = p.slope.x + double{p.twist} * foot.fraction.y;
  const double south = p.slope.y + double{p.twist} * foot.fraction.x;
  const double closing = east * texels.x + south * texels.y - rise;
  largest.at = vec2(largest_of_hit(hit.at.x, texels.x, height, closing),
                    largest_of_hit(hit.at.y, texels.y, height, closing));
  largest.depth = largest_of_hit(hit.depth, 1, height, closing);
  return largest;
}

// The same for a dive: the root of a discriminant, whose two terms may cancel, moves by that rounding times
// the root's derivative by the discriminant.
float largest_of_dive(const M& modules, M::GnomonCrossing crossing, float clearance, float crossed,
                      bool above) {
  const float dive = modules.gnomon_dive(crossing, clearance, crossed, above);
  if (dive >= GNOMON_NEVER) return 0;
  const double slope = crossing.slope;
  const double product = 4.0 * crossing.curvature * clearance;
  const double root = std::sqrt(std::max(slope * slope - product, 1e-60));
  const double terms = std::max(slope * slope, std::abs(product));
  const double moved = slope > 0
                           ? std::abs(double{clearance}) * terms / ((slope + root) * (slope + root) * root)
                           : terms / (4 * std::abs(double{crossing.curvature}) * root);
  return static_cast<float>(std::max({double{dive}, moved, double{kZeroOfEitherSign}}));
}

std::vector<Row> shading_rows() {
  const auto direction = [](Random& r) {
    return normalize(vec3(r.between(-1, 1), r.between(-1, 1), r.between(-1, 1)));
  };
  return {
      // The slopes are bilinear sums, then divided and normalised.
      within_4_ulp(
          "gnomon_surface_normal", &M::gnomon_surface_normal,
          [](Random& r) {
            return std::tuple{r.map(), r.receiver(), r.whole(0, 7)};
          },
          [](const M& modules, M::GnomonMap map, M::GnomonReceiver receiver, int q) {
            const M::GnomonPatch p = modules.gnomon_patch(
                receiver.patch_index, modules.gnomon_host_height(receiver.patch_index, q), q);
            const float east = (std::abs(p.slope.x) + std::abs(p.twist)) / map.spacing.x;
            const float south = (std::abs(p.slope.y) + std::abs(p.twist)) / map.spacing.y;
            return vec3(std::max({1.0F, east, south}));
          }),
      // dot() may be summed in any order.
      within_4_ulp(
          "gnomon_lit", &M::gnomon_lit,
          [direction](Random& r) {
            return std::tuple{vec3(r.between(0, 1), r.between(0, 1), r.between(0, 1)), direction(r),
                              direction(r), r.between(0, 1), r.between(0, 1)};
          },
          [](const M&, vec3, vec3, vec3, float, float) { return vec3(1.0F); }),
  };
}

std::vector<Row> view_rows() {
  const auto dive_arguments = [](Random& r) {
    const auto crossing = r.crossing();
    const float crossed = 1.5F * r.fraction();
    const float clearance = r.clearance(crossing, crossed);
    return std::tuple{crossing, r.chance(0.3F) ? -clearance : clearance, crossed, r.chance(0.5F)};
  };
  return {
      // Dot products may be summed in any order; edge-on ground divides by little.
      within_4_ulp(
          "gnomon_footprint", &M::gnomon_footprint,
          [](Random& r) {
            const auto map = r.map();
            const vec3 normal = normalize(vec3(r.between(-1, 1), r.between(-1, 1), r.between(0.1F, 1)));
            const vec3 direction(r.between(-1, 1), r.between(-1, 1), r.between(-1, 1));
            return std::tuple{map, normal, direction,
                              vec3(r.between(-100, 100), r.between(-100, 100), r.between(-100, 100))};
          },
          [](const M&, M::GnomonMap map, vec3 normal, vec3 direction, vec3 moved) {
            const double facing = std::min(double{dot(normal, direction)}, -1e-6 * double{length(direction)});
            const double share =
                3 * double{length(moved)} / -facing;  // of the direction, its own rounding too
            const double error =
                share * double{length(direction)} * (1 + double{length(direction)} / -facing);
            return vec2(static_cast<float>(double{length(moved)} + error)) / map.spacing;
          }),
      exact("gnomon_hit", &M::gnomon_hit,
            [](Random& r) {
              return std::tuple{vec2(r.coordinate(133), r.coordinate(70)), r.between(0, 1e5F),
                                r.whole(0, 200000), r.whole(0, 2)};
            }),
      exact("gnomon_cut_span", &M::gnomon_cut_span,
            [](Random& r) {
              return std::tuple{M::GnomonSpan{r.between(0, 10), r.chance(0.5F) ? GNOMON_NEVER : 20.0F},
                                r.between(-10, 200), r.chance(0.1F) ? 0.0F : r.power_of_ten(-3, 2), 0.0F,
                                r.between(1, 133)};
            }),
      deciding(within_4_ulp(
          "gnomon_dive_root", &M::gnomon_dive_root,
          [](Random& r) {
            const auto crossing = r.crossing();
            const float clearance = r.clearance(crossing, r.fraction());
            const float discriminant =
                crossing.slope * crossing.slope - 4.0F * crossing.curvature * clearance;
            return std::tuple{crossing, clearance, std::sqrt(std::max(discriminant, 0.0F))};
          },
          [](const M& modules, M::GnomonCrossing crossing, float clearance, float root) {
            return 2.0F * std::abs(modules.gnomon_dive_root(crossing, clearance, root));
          })),
      deciding(within_4_ulp("gnomon_dive", &M::gnomon_dive, dive_arguments, largest_of_dive)),
      deciding(within_4_ulp(
          "gnomon_view_walk", &M::gnomon_view_walk,
          [](Random& r) {
            const auto map = r.map();
            auto ray = r.ray();
            ray.rise = -ray.rise;
            ray.height += r.between(0, 2000);
            return std::tuple{map, ray, r.chance(0.9F), 0,
                              r.chance(0.1F) ? r.whole(0, 50) : r.modules().step_limit()};
          },
          [](const M& modules, M::GnomonMap map, M::GnomonRay ray, bool above, int q, int limit) {
            const M::GnomonHit hit = modules.gnomon_view_walk(map, ray, above, q, limit);
            return largest_of_hit(modules, hit, ray.direction, ray.rise,
                                  std::max(std::abs(ray.height), map.highest), q);
          })),
      deciding(within_4_ulp(
          "gnomon_relief_view", &M::gnomon_relief_view,
          [](Random& r) {
            const auto map = r.map();
            const auto view = r.view(map);
            return std::tuple{map, view.origin, view.direction, 0, r.modules().step_limit()};
          },
          [](const M& modules, M::GnomonMap map, vec3 origin, vec3 direction, int q, int limit) {
            const M::GnomonHit hit = modules.gnomon_relief_view(map, origin, direction, q, limit);
            const dvec2 texels(direction.x / map.spacing.x, -direction.y / map.spacing.y);
            return largest_of_hit(
                modules, hit, texels, direction.z,
                std::max({std::abs(origin.z), map.highest, std::abs(direction.z * hit.depth)}), q);
          })),
  };
}

}  // namespace

std::vector<Row> rows_of_views() {
  std::vector<Row> all;
  for (auto make : {view_rows, shading_rows}) {
    for (Row& row : make()) all.push_back(std::move(row));
  }
  return all;
}

}  // namespace gnomon::modules
