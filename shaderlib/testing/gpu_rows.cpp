// SPDX-License-Identifier: MIT
#include "testing/gpu_rows.h"

#include "testing/row_makers.h"

namespace gnomon::modules {
namespace {

using M = Modules;
using Random = RandomArguments;

std::vector<Row> map_and_shadow_rows() {
  return {
      exact("gnomon_patch_of", &M::gnomon_patch_of,
            [](Random& r) { return std::tuple{r.coordinate(r.chance(0.2F) ? 1e6F : 133)}; }),
      exact("gnomon_receiver_at", &M::gnomon_receiver_at,
            [](Random& r) {
              return std::tuple{r.coordinate(16384), r.coordinate(133), r.height_above_ground()};
            }),
      exact("gnomon_shadow", &M::gnomon_shadow,
            [](Random& r) {
              return std::tuple{r.between(0, 1), r.whole(0, 200000), r.whole(0, 6)};
            }),
      exact("gnomon_shadow_without_ray", &M::gnomon_shadow_without_ray,
            [](Random& r) { return std::tuple{r.any_sun()}; }),
      // pow() is no sum, but GPUs compute it as exp2(shadow * log2(k)).
      within_4_ulp(
          "gnomon_k_shadow", &M::gnomon_k_shadow,
          [](Random& r) {
            const float shadow = static_cast<float>(r.whole(0, 1));
            return std::tuple{r.chance(0.5F) ? r.between(0, 1) : shadow, r.between(-1, 1), r.between(0, 1),
                              r.between(0, 1)};
          },
          [](const M&, float shadow, float sun_height, float dark, float bright) {
            if (shadow <= 0 || shadow >= 1) return 0.0F;
            const double k = dark + (double{bright} - dark) * std::max(double{sun_height}, 0.0);
            return static_cast<float>(std::max(std::abs(std::log2(k)), std::pow(k, double{shadow})));
          }),
  };
}

// Heights that are stored as integers: every GPU has to see the same map.
std::vector<Row> decode_rows() {
  return {
      exact("gnomon_stored_number", &M::gnomon_stored_number,
            [](Random& r) {
              const int largest = r.chance(0.5F) ? 255 : 65535;
              const float channel = static_cast<float>(r.whole(0, largest)) / static_cast<float>(largest);
              return std::tuple{r.chance(0.5F) ? channel : r.between(0, 1), static_cast<float>(largest)};
            }),
      exact("gnomon_stored_rgb", &M::gnomon_stored_rgb,
            [](Random& r) {
              const auto channel = [&] { return static_cast<float>(r.whole(0, 255)) / 255.0F; };
              return std::tuple{channel(), channel(), channel()};
            }),
      // `precise` keeps product and sum apart.
      exact("gnomon_scaled_height", &M::gnomon_scaled_height,
            [](Random& r) {
              return std::tuple{r.whole(0, 65535), r.power_of_ten(-4, 2), r.power_of_ten(0, 5)};
            }),
      exact("gnomon_exact_tenth", &M::gnomon_exact_tenth,
            [](Random& r) {
              const int whole = r.whole(-16777215, 16777215);
              const float off = 1.0F + 0x1p-23F * static_cast<float>(r.whole(-3, 3));
              return std::tuple{whole, static_cast<float>(whole) / 10.0F * off};
            }),
      exact("gnomon_terrain_rgb_height", &M::gnomon_terrain_rgb_height,
            [](Random& r) { return std::tuple{r.whole(0, 0xFFFFFF)}; }),
      exact("gnomon_terrarium_height", &M::gnomon_terrarium_height,
            [](Random& r) { return std::tuple{r.whole(0, 0xFFFFFF)}; }),
  };
}

std::vector<Row> patch_rows() {
  return {
      exact("gnomon_is_sample", &M::gnomon_is_sample,
            [](Random& r) { return std::tuple{r.chance(0.3F) ? GNOMON_NO_SAMPLE : r.power_of_ten(-3, 30)}; }),
      exact("gnomon_patch_has_surface", &M::gnomon_patch_has_surface,
            [](Random& r) {
              return std::tuple{r.patch_index(), r.whole(0, 7)};
            }),
      exact("gnomon_on_surface", &M::gnomon_on_surface,
            [](Random& r) {
              return std::tuple{r.receiver(), r.whole(0, 7)};
            }),
      exact("gnomon_has_surface", &M::gnomon_has_surface,
            [](Random& r) {
              return std::tuple{r.receiver(), r.whole(0, 7)};
            }),
      exact("gnomon_patch", &M::gnomon_patch,
            [](Random& r) {
              return std::tuple{r.patch_index(), r.between(-100, 3000), r.whole(0, 7)};
            }),
      exact("gnomon_patch_height", &M::gnomon_patch_height,
            [](Random& r) {
              return std::tuple{r.patch(), vec2(r.fraction(), r.fraction())};
            }),
      exact("gnomon_enter_patch", &M::gnomon_enter_patch,
            [](Random& r) {
              return std::tuple{r.chance(0.2F) ? 0.0F : r.power_of_ten(-12, 0), r.whole(0, 16384),
                                r.fraction()};
            }),
      exact("gnomon_inverse", &M::gnomon_inverse,
            [](Random& r) { return std::tuple{r.chance(0.2F) ? 0.0F : r.power_of_ten(-12, 0)}; }),
      exact("gnomon_domain_exit", &M::gnomon_domain_exit,
            [](Random& r) {
              return std::tuple{r.power_of_ten(-6, 4), r.chance(0.2F) ? 0.0F : r.power_of_ten(-12, 0)};
            }),
  };
}

std::vector<Row> ray_rows() {
  return {
      // The height is a bilinear sum. The end of a ray that stands in a corner is min(0, -0).
      within_4_ulp(
          "gnomon_ray", &M::gnomon_ray,
          [](Random& r) {
            return std::tuple{r.map(), r.receiver(), r.sun(), r.whole(0, 7)};
          },
          [](const M& modules, M::GnomonMap map, M::GnomonReceiver receiver, vec3 sun, int q) {
            const M::GnomonRay ray = modules.gnomon_ray(map, receiver, sun, q);
            M::GnomonRay largest{};
            const Bilinear ground(modules.gnomon_patch(ray.start, ray.base, q), ray.fraction);
            largest.height = ground.of_height(receiver.height);
            largest.t_end = kZeroOfEitherSign;
            return largest;
          }),
      within_4_ulp(
          "gnomon_ray_from_ground", &M::gnomon_ray_from_ground,
          [](Random& r) {
            return std::tuple{r.ray(), r.height_above_ground(), r.between(-100, 3000), r.whole(0, 7)};
          },
          [](const M& modules, M::GnomonRay given, float height, float datum, int q) {
            const M::GnomonRay ray = modules.gnomon_ray_from_ground(given, height, datum, q);
            M::GnomonRay largest{};
            const Bilinear ground(modules.gnomon_patch(ray.start, ray.base, q), ray.fraction);
            largest.height = ground.of_height(height);
            return largest;
          }),
      exact("gnomon_ray_on_edges", &M::gnomon_ray_on_edges, [](Random& r) { return std::tuple{r.ray()}; }),
      exact("gnomon_ray_other_side", &M::gnomon_ray_other_side,
            [](Random& r) { return std::tuple{r.ray()}; }),
      within_4_ulp(
          "gnomon_crossed", &M::gnomon_crossed,
          [](Random& r) {
            const auto at = r.place(7);
            return std::tuple{at.ray, at.cursor.t, at.exits};
          },
          [](const M&, M::GnomonRay, float, vec2) { return kZeroOfEitherSign; }),
      exact("gnomon_ray_exits", &M::gnomon_ray_exits,
            [](Random& r) {
              const auto at = r.place(7);
              return std::tuple{at.ray, at.low, at.level};
            }),
      exact("gnomon_ray_next", &M::gnomon_ray_next,
            [](Random& r) {
              const auto at = r.place(7);
              return std::tuple{at.ray, at.cursor.patch_index, at.low, at.level, at.exits};
            }),
  };
}

std::vector<Row> crossing_rows() {
  return {
      // Slope and height at the entry are bilinear sums.
      within_4_ulp(
          "gnomon_crossing", &M::gnomon_crossing,
          [](Random& r) {
            const auto at = r.place(0);
            return std::tuple{at.ray, at.cursor.patch_index, at.cursor.t, r.whole(0, 7)};
          },
          [](const M& modules, M::GnomonRay ray, ivec2 patch, float t, int q) {
            const dvec2 entry =
                dvec2(ray.fraction) + dvec2(ray.direction) * double{t} - dvec2(patch - ray.start);
            const Bilinear ground(modules.gnomon_patch(patch, ray.base, q), clamp(entry, dvec2(0), dvec2(1)));
            return M::GnomonCrossing{
                .slope = ground.of_slope(ray), .curvature = 0, .above = ground.of_height()};
          }),
      exact("gnomon_clearance_at", &M::gnomon_clearance_at,
            [](Random& r) {
              return std::tuple{r.crossing(), r.chance(0.2F) ? 0.0F : -std::abs(r.power_of_ten(-6, 4)),
                                1.5F * r.fraction()};
            }),
      deciding(exact("gnomon_crossing_hides", &M::gnomon_crossing_hides,
                     [](Random& r) {
                       const auto crossing = r.crossing();
                       const float crossed = 1.5F * r.fraction();
                       return std::tuple{crossing, r.clearance(crossing, crossed), crossed};
                     })),
      within_4_ulp(
          "gnomon_far_clearance", &M::gnomon_far_clearance,
          [](Random& r) {
            const auto at = r.place(0);
            return std::tuple{at.ray, r.crossing(), at.cursor.t, r.chance(0.2F)};
          },
          [](const M&, M::GnomonRay ray, M::GnomonCrossing crossing, float t, bool) {
            return std::max(
                {std::abs(crossing.above), std::abs(ray.height), std::abs(ray.rise * t), kZeroOfEitherSign});
          }),
      deciding(exact("gnomon_far_patch_hides", &M::gnomon_far_patch_hides,
                     [](Random& r) {
                       const auto at = r.place(0);
                       return std::tuple{at.ray, r.crossing(), at.cursor.t, at.exits, r.chance(0.2F)};
                     })),
  };
}

std::vector<Row> walk_rows() {
  return {
      within_4_ulp(
          "gnomon_leave_block", &M::gnomon_leave_block,
          [](Random& r) {
            const auto at = r.place(7);
            return std::tuple{at.ray,   at.cursor, at.low,
                              at.level, at.exits,  r.chance(0.2F) ? GNOMON_NEVER : r.between(0, 100)};
          },
          [](const M&, M::GnomonRay, M::GnomonCursor, ivec2, int, vec2, float) {
            return M::GnomonCursor{.patch_index = {}, .t = kZeroOfEitherSign, .steps = 0, .cause = 0};
          }),
      within_4_ulp(
          "gnomon_leave_patch", &M::gnomon_leave_patch,
          [](Random& r) {
            const auto at = r.place(0);
            return std::tuple{at.ray, at.cursor, r.crossing(), at.exits,
                              r.chance(0.2F) ? GNOMON_NEVER : r.between(0, 100)};
          },
          [](const M&, M::GnomonRay, M::GnomonCursor, M::GnomonCrossing, vec2, float) {
            return M::GnomonCursor{.patch_index = {}, .t = kZeroOfEitherSign, .steps = 0, .cause = 0};
          }),
      exact("gnomon_t_above", &M::gnomon_t_above,
            [](Random& r) {
              return std::tuple{r.map(), r.ray()};
            }),
      exact("gnomon_cursor_at_start", &M::gnomon_cursor_at_start,
            [](Random& r) { return std::tuple{r.ray()}; }),
      exact("gnomon_repeat_on_other_side", &M::gnomon_repeat_on_other_side,
            [](Random& r) {
              auto at = r.place(0);
              at.cursor.cause = r.whole(0, 5);
              return std::tuple{at.ray, at.cursor};
            }),
      exact("gnomon_walk_answer", &M::gnomon_walk_answer,
            [](Random& r) {
              return std::tuple{M::GnomonCursor{r.patch_index(), r.between(0, 100), r.whole(0, 200000),
                                                r.whole(0, 5), r.chance(0.5F), r.chance(0.5F)}};
            }),
      exact("gnomon_carried_clearance", &M::gnomon_carried_clearance,
            [](Random& r) {
              return std::tuple{r.crossing(), r.chance(0.2F) ? 0.0F : -std::abs(r.power_of_ten(-6, 4)),
                                r.chance(0.2F) ? 0.0F : 1.5F * r.fraction()};
            }),
      deciding(exact("gnomon_near_walk", &M::gnomon_near_walk,
                     [](Random& r) {
                       const auto map = r.map();
                       const auto receiver = r.receiver();
                       return std::tuple{r.modules().gnomon_ray(map, receiver, r.sun(), 0), receiver.height,
                                         r.whole(0, 7)};
                     })),
  };
}

std::vector<Row> method_rows() {
  const auto shadow_arguments = [](Random& r) {
    const auto map = r.map();
    const auto receiver = r.receiver();
    const vec3 sun = r.chance(0.005F) ? r.sun_at_horizon(map, receiver) : r.any_sun();
    return std::tuple{map, receiver, sun, r.whole(0, 7),
                      r.chance(0.1F) ? r.whole(0, 50) : r.modules().step_limit()};
  };
  return {
      deciding(exact("gnomon_brute_force", &M::gnomon_brute_force, shadow_arguments)),
      deciding(exact("gnomon_multilevel", &M::gnomon_multilevel, shadow_arguments)),
      deciding(exact("gnomon_far_walk", &M::gnomon_far_walk,
                     [](Random& r) {
                       const auto map = r.map();
                       const auto at = r.place(0);
                       return std::tuple{map,
                                         at.ray,
                                         r.modules().gnomon_cursor_at_start(at.ray),
                                         r.modules().gnomon_t_above(map, at.ray),
                                         r.whole(0, 7),
                                         r.chance(0.1F) ? r.whole(0, 50) : r.modules().step_limit()};
                     })),
  };
}

std::vector<Row> relief_rows() {
  return {
      exact("gnomon_coarser_height", &M::gnomon_coarser_height,
            [](Random& r) {
              const ivec2 size = r.modules().map().size;
              return std::tuple{ivec2(r.whole(0, (size.x - 1) / 2), r.whole(0, (size.y - 1) / 2)), size,
                                r.whole(0, 7)};
            }),
      exact("gnomon_extrema_of_patches", &M::gnomon_extrema_of_patches,
            [](Random& r) {
              return std::tuple{r.patch_index() / 2, r.whole(0, 7)};
            }),
      exact("gnomon_extrema_of_blocks", &M::gnomon_extrema_of_blocks,
            [](Random& r) {
              const int level = r.whole(2, 7);
              return std::tuple{r.patch_index() >> level, level, r.whole(0, 7)};
            }),
      exact("gnomon_climb", &M::gnomon_climb,
            [](Random& r) {
              const ivec2 left = r.patch_index();
              const int reach = 1 << r.whole(0, 7);
              return std::tuple{left, left + ivec2(r.whole(-reach, reach), r.whole(-reach, reach)),
                                r.whole(0, 7), r.whole(1, 14)};
            }),
  };
}

}  // namespace

std::vector<Row> rows() {
  std::vector<Row> all;
  for (auto make : {map_and_shadow_rows, decode_rows, patch_rows, ray_rows, crossing_rows, walk_rows,
                    method_rows, relief_rows, rows_of_the_papers, rows_of_views, rows_of_meshes}) {
    for (Row& row : make()) all.push_back(std::move(row));
  }
  return all;
}

}  // namespace gnomon::modules
