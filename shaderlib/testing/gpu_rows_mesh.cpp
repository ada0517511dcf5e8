// SPDX-License-Identifier: MIT
// Rows of the modules in mesh/, and of baseline/cascaded_shadow_maps.
#include "testing/row_makers.h"

namespace gnomon::modules {
namespace {

using M = Modules;
using Random = RandomArguments;

// Largest height that a height on the mesh is made of.
float largest_height(const Random& r) {
  float largest = 1;
  for (const float sample : r.modules().heights().samples)
    if (sample > -1e20F) largest = std::max(largest, std::abs(sample));
  return largest;
}

vec3 direction(Random& r) {
  return normalize(vec3(r.between(-1, 1), r.between(-1, 1), r.between(0.05F, 1)));
}

// Squares that grow around a common middle, as cascades do.
M::GnomonLight light(Random& r) {
  M::GnomonLight light{};
  light.origin = vec3(r.between(-1e3F, 1e3F), r.between(-1e3F, 1e3F), r.between(0, 5e3F));
  light.right = direction(r);
  light.down = direction(r);
  light.range = std::abs(r.power_of_ten(2, 5));
  light.size = 64 << r.whole(0, 4);
  light.cascades = r.whole(1, GNOMON_MOST_CASCADES);
  light.grid_step = r.whole(1, 9);
  light.bias = r.between(0, 2);
  light.slope_bias = r.between(0, 2);
  light.filter_width = 2 * r.whole(0, 3) + 1;
  float texel = std::abs(r.power_of_ten(-2, 1));
  for (M::GnomonCascade& cascade : light.cascade) {
    cascade = {.corner = vec2(r.between(-0.6F, -0.4F), r.between(-0.6F, -0.4F)) * texel *
                         static_cast<float>(light.size),
               .texel = texel};
    texel *= r.between(1, 4);
  }
  return light;
}

std::vector<Row> grid_rows() {
  return {
      exact("gnomon_grid_nodes", &M::gnomon_grid_nodes,
            [](Random& r) {
              return std::tuple{r.whole(1, 16384), r.whole(1, 1024)};
            }),
      exact("gnomon_grid_coordinate", &M::gnomon_grid_coordinate,
            [](Random& r) {
              const int samples = r.whole(1, 500);
              return std::tuple{r.whole(0, 510), samples,
                                static_cast<float>(samples) - (r.chance(0.5F) ? 0.0F : r.between(0, 1)),
                                r.whole(1, 20)};
            }),
      exact("gnomon_grid_cell", &M::gnomon_grid_cell,
            [](Random& r) {
              return std::tuple{r.coordinate(133), r.whole(1, 133), r.whole(1, 20)};
            }),
      within_4_ulp(
          "gnomon_grid_height", &M::gnomon_grid_height,
          [](Random& r) {
            return std::tuple{r.coordinate(133), r.coordinate(70), 0};
          },
          [](const M& modules, float column, float row, int q) {
            const auto at = modules.gnomon_receiver_at(column, row, 0);
            const float base = modules.gnomon_host_height(at.patch_index, q);
            const auto p = modules.gnomon_patch(at.patch_index, base, q);
            return Bilinear(p, at.fraction).of_height(base);
          }),
  };
}

// A corner's height and two differences of heights, each times a share.
M::GnomonGridPoint largest_of_point(const M& modules, M::GnomonMap map, float column, float row, int step,
                                    int q) {
  const int west = modules.gnomon_grid_cell(column, map.size.x, step);
  const int north = modules.gnomon_grid_cell(row, map.size.y, step);
  const auto x = [&](int node) {
    return modules.gnomon_grid_coordinate(node, map.size.x, map.domain.x, step);
  };
  const auto y = [&](int node) {
    return modules.gnomon_grid_coordinate(node, map.size.y, map.domain.y, step);
  };
  float largest = 0;
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const float height = modules.gnomon_grid_height(x(west + i), y(north + j), q);
      largest = std::max(largest, 2 * std::abs(height));
    }
  const float smallest_side = std::min(std::max(x(west + 1) - x(west), 1e-6F) * map.spacing.x,
                                       std::max(y(north + 1) - y(north), 1e-6F) * map.spacing.y);
  // Heights on nodes between samples are rounded sums.
  return {.height = 4 * largest, .normal = vec3(1 + largest / smallest_side), .hole = false};
}

std::vector<Row> grid_point_rows() {
  return {within_4_ulp(
      "gnomon_grid_point", &M::gnomon_grid_point,
      [](Random& r) {
        return std::tuple{r.map(), r.coordinate(133), r.coordinate(70), r.whole(1, 20), 0};
      },
      largest_of_point)};
}

// The root of a difference that cancels near 1.
float largest_bias(const M::GnomonLight& taken, float texel, float facing) {
  const float sine = std::sqrt(std::max(1 - facing * facing, 0.0F));
  const float moved = (sine + std::min(0.5F / std::max(sine, 1e-30F), 4096.0F)) / std::max(facing, 1e-3F);
  const float widest = 0.5F * static_cast<float>(taken.filter_width - 1);
  return taken.range + texel * (taken.bias + (taken.slope_bias + widest) * (64 + moved));
}

std::vector<Row> cascade_rows() {
  const auto plane = [](Random& r) { return vec2(r.between(-1e3F, 1e3F), r.between(-1e3F, 1e3F)); };
  return {
      exact("gnomon_cascade_texel", &M::gnomon_cascade_texel,
            [plane](Random& r) {
              return std::tuple{light(r).cascade[0], plane(r)};
            }),
      deciding(exact("gnomon_cascade_of", &M::gnomon_cascade_of,
                     [plane](Random& r) {
                       const auto taken = light(r);
                       return std::tuple{taken, plane(r) * (taken.cascade[0].texel * 0.1F)};
                     })),
      within_4_ulp(
          "gnomon_cascade_bias", &M::gnomon_cascade_bias,
          [](Random& r) {
            return std::tuple{light(r), std::abs(r.power_of_ten(-2, 2)), r.fraction()};
          },
          [](const M&, M::GnomonLight taken, float texel, float facing) {
            return largest_bias(taken, texel, facing);
          }),
      exact("gnomon_cascade_share", &M::gnomon_cascade_share,
            [](Random& r) {
              return std::tuple{light(r), r.whole(0, 3), vec2(r.between(0, 1024), r.between(0, 1024)),
                                r.between(-0.1F, 1.1F)};
            }),
      // A sum of a coordinate and a thousandth.
      deciding(within_4_ulp(
          "gnomon_towards_sun", &M::gnomon_towards_sun,
          [](Random& r) {
            return std::tuple{r.map(), r.receiver(), r.sun(), 0};
          },
          [](const M&, M::GnomonMap map, M::GnomonReceiver, vec3, int) {
            return M::GnomonReceiver{.patch_index = ivec2(0), .fraction = map.domain + vec2(1), .height = 0};
          })),
      within_4_ulp(
          "gnomon_mesh_under", &M::gnomon_mesh_under,
          [](Random& r) {
            return std::tuple{r.map(), r.receiver(), r.whole(1, 20), 0};
          },
          [](const M& modules, M::GnomonMap map, M::GnomonReceiver receiver, int step, int q) {
            const vec2 at = vec2(receiver.patch_index) - vec2(0.5F) + receiver.fraction;
            const auto p = modules.gnomon_patch(receiver.patch_index,
                                                modules.gnomon_host_height(receiver.patch_index, q), q);
            M::GnomonGridPoint largest = largest_of_point(modules, map, at.x, at.y, step, q);
            largest.height += 4 * Bilinear(p, receiver.fraction).of_height();
            largest.normal += (std::abs(p.slope.x) + std::abs(p.slope.y) + std::abs(p.twist)) /
                              std::min(map.spacing.x, map.spacing.y);
            return largest;
          }),
      within_4_ulp(
          "gnomon_cascade_lift", &M::gnomon_cascade_lift,
          [](Random& r) {
            const M::GnomonGridPoint on{.height = 0, .normal = direction(r), .hole = false};
            return std::tuple{light(r), std::abs(r.power_of_ten(-2, 2)), on, r.sun(),
                              r.height_above_ground()};
          },
          [](const M&, M::GnomonLight taken, float texel, M::GnomonGridPoint on, vec3 to_sun, float height) {
            const float facing = std::max(dot(on.normal, to_sun), 1e-6F);
            return largest_bias(taken, texel, facing) / facing + height / (facing * facing);
          }),
      deciding(within_4_ulp(
          "gnomon_cascaded_shadow_maps", &M::gnomon_cascaded_shadow_maps,
          [](Random& r) {
            const auto map = r.map();
            const vec3 sun = r.any_sun();
            auto taken = light(r);
            taken.range = 10 * largest_height(r);
            return std::tuple{map, r.receiver(), sun, 0, taken};
          },
          [](const M&, M::GnomonMap, M::GnomonReceiver, vec3, int, M::GnomonLight) {
            return M::GnomonShadow{.shadow = 1, .steps = 0, .cause = 0};
          })),
  };
}

}  // namespace

std::vector<Row> rows_of_meshes() {
  std::vector<Row> all;
  for (auto make : {grid_rows, grid_point_rows, cascade_rows}) {
    for (Row& row : make()) all.push_back(std::move(row));
  }
  return all;
}

}  // namespace gnomon::modules
