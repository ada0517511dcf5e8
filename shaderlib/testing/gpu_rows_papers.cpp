// SPDX-License-Identifier: MIT
// Rows of the papers' own algorithms: level of detail, transit points, H_ext and the walk over it.
#include "testing/row_makers.h"

namespace gnomon::modules {
namespace {

using M = Modules;
using Random = RandomArguments;

// Derivatives of a place on the map: any, and those whose ratios are exact.
vec2 derivative(Random& r) {
  if (r.chance(0.1F)) return {0, 0};
  const float length =
      r.chance(0.4F) ? std::exp2(static_cast<float>(r.whole(-3, 9))) : std::abs(r.power_of_ten(-3, 5));
  if (r.chance(0.4F)) return r.chance(0.5F) ? vec2(length, 0) : vec2(0, -length);
  return {length * r.between(-1, 1), length * r.between(-1, 1)};
}

std::vector<Row> level_of_detail_rows() {
  const auto square = [](Random& r) {
    const vec2 d = derivative(r);
    return d.x * d.x + d.y * d.y;
  };
  return {
      deciding(
          exact("gnomon_anisotropy", &M::gnomon_anisotropy,
                [square](Random& r) {
                  const float longer = square(r);
                  return std::tuple{longer, std::min(longer, square(r)), static_cast<float>(r.whole(1, 16))};
                })),
      // log2() is not exact.
      deciding(exact(
          "gnomon_level_of_detail", &M::gnomon_level_of_detail,
          [](Random& r) {
            const vec2 along_x = derivative(r);
            return std::tuple{along_x, derivative(r), static_cast<float>(r.whole(1, 16)), r.whole(0, 14)};
          })),
  };
}

// A block of texels and a track through it; entries on the block's edge, and rounded beyond it, often.
struct Texels {
  vec2 entry;
  ivec2 low;
  int side;
  vec2 direction;
};
Texels texels(Random& r) {
  const int level = r.whole(0, 7);
  Texels at{.entry = {}, .low = (r.patch_index() >> level) << level, .side = 1 << level, .direction = {}};
  const auto side = static_cast<float>(at.side);
  at.entry = vec2(at.low) + vec2(r.fraction(), r.fraction()) * side;
  if (at.entry.x > 0 && r.chance(0.1F))
    at.entry.x = std::nextafter(at.entry.x, r.chance(0.5F) ? -1.0F : 1e4F);
  const vec3 sun = r.sun();
  at.direction = vec2(sun.x, -sun.y) / std::sqrt(sun.x * sun.x + sun.y * sun.y);
  if (r.chance(0.1F)) at.direction.x *= r.power_of_ten(-9, -5);
  if (r.chance(0.02F)) at.direction = vec2(0);
  return at;
}

std::vector<Row> transit_rows() {
  return {
      // From an edge the way is min(0, -0).
      within_4_ulp(
          "gnomon_transit", &M::gnomon_transit,
          [](Random& r) {
            const Texels at = texels(r);
            return std::tuple{at.entry, at.low, at.side, at.direction};
          },
          [](const M&, vec2, ivec2, int, vec2) {
            return M::GnomonTransit{.t = kZeroOfEitherSign, .offset = {}};
          }),
      exact("gnomon_transit_next", &M::gnomon_transit_next,
            [](Random& r) {
              const Texels at = texels(r);
              const auto transit = r.modules().gnomon_transit(at.entry, at.low, at.side, at.direction);
              const ivec2 current = at.low + ivec2(r.whole(0, at.side - 1), r.whole(0, at.side - 1));
              return std::tuple{transit,     at.entry + at.direction * transit.t, current, at.low, at.side,
                                at.direction};
            }),
  };
}

std::vector<Row> literal_extrema_rows() {
  return {
      exact("gnomon_corner_height", &M::gnomon_corner_height,
            [](Random& r) { return std::tuple{r.patch_index()}; }),
      exact(
          "gnomon_wider_extrema", &M::gnomon_wider_extrema,
          [](Random& r) {
            return std::tuple{vec2(r.between(0, 9), r.between(0, 9)), vec2(r.between(0, 9), r.between(0, 9))};
          }),
      exact("gnomon_literal_extrema_of_texels", &M::gnomon_literal_extrema_of_texels,
            [](Random& r) { return std::tuple{r.patch_index() / 2}; }),
      exact("gnomon_literal_extrema_of_blocks", &M::gnomon_literal_extrema_of_blocks,
            [](Random& r) {
              const int level = r.whole(2, 7);
              return std::tuple{min(r.patch_index(), r.modules().map().size - 1) >> level, level};
            }),
  };
}

// What the literal method takes at level q, as sizes and as places.
struct LiteralPlace {
  M::GnomonMap map;
  M::GnomonReceiver receiver;
  int q;
};
LiteralPlace literal_place(Random& r) {
  LiteralPlace at{.map = r.map(), .receiver = {}, .q = r.chance(0.5F) ? 0 : r.whole(0, 7)};
  const int side = 1 << at.q;
  at.map.size = (at.map.size + side - 1) / side;
  at.map.domain /= static_cast<float>(side);
  at.map.top_level = r.modules().literal_top_level();
  const float column = r.coordinate(at.map.domain.x);
  at.receiver =
      r.modules().gnomon_receiver_at(column, r.coordinate(at.map.domain.y), r.height_above_ground());
  return at;
}

// Of a height that is a bilinear sum.
float largest_of_literal_height(const M& modules, vec2 at, int q, float above = 0) {
  const M::GnomonReceiver place = modules.gnomon_receiver_at(at.x, at.y, 0);
  return Bilinear(modules.gnomon_patch(place.patch_index, 0, q), place.fraction).of_height(above);
}

std::vector<Row> literal_rows() {
  const auto ahead = [](Random& r) { return vec2(r.coordinate(133), r.coordinate(70)); };
  return {
      deciding(exact("gnomon_literal_flag", &M::gnomon_literal_flag,
                     [](Random& r) {
                       const vec3 sun = r.any_sun();
                       const float far = r.between(0, 2000);
                       return std::tuple{
                           r.chance(0.2F) ? sun * far : vec3(sun.x * far, sun.y * far, r.power_of_ten(-2, 3)),
                           sun};
                     })),
      deciding(exact("gnomon_literal_hides", &M::gnomon_literal_hides,
                     [ahead](Random& r) {
                       const LiteralPlace at = literal_place(r);
                       const auto track =
                           r.modules().gnomon_literal_track(at.map, at.receiver, r.sun(), at.q);
                       return std::tuple{at.map, track, ahead(r), r.between(-100, 3000)};
                     })),
      within_4_ulp(
          "gnomon_literal_height", &M::gnomon_literal_height,
          [ahead](Random& r) {
            return std::tuple{ahead(r), r.whole(0, 7)};
          },
          [](const M& modules, vec2 at, int q) { return largest_of_literal_height(modules, at, q); }),
      within_4_ulp(
          "gnomon_literal_track", &M::gnomon_literal_track,
          [](Random& r) {
            const LiteralPlace at = literal_place(r);
            return std::tuple{at.map, at.receiver, r.sun(), at.q};
          },
          [](const M& modules, M::GnomonMap map, M::GnomonReceiver receiver, vec3 sun, int q) {
            const M::GnomonTrack track = modules.gnomon_literal_track(map, receiver, sun, q);
            return M::GnomonTrack{
                .start = {},
                .height = largest_of_literal_height(modules, track.start, q, receiver.height),
                .direction = {},
                .to_sun = {}};
          }),
      deciding(exact("gnomon_literal_look", &M::gnomon_literal_look,
                     [ahead](Random& r) {
                       const LiteralPlace at = literal_place(r);
                       const auto track =
                           r.modules().gnomon_literal_track(at.map, at.receiver, r.sun(), at.q);
                       const int level = r.whole(at.q, 7);
                       const ivec2 texel = min(r.patch_index(), r.modules().map().size - 1);
                       const vec2 entry = ahead(r);
                       return std::tuple{
                           at.map,         track, entry, entry + track.direction * r.between(0, 9),
                           texel >> level, level, at.q};
                     })),
      deciding(exact("gnomon_multilevel_literal", &M::gnomon_multilevel_literal,
                     [](Random& r) {
                       const LiteralPlace at = literal_place(r);
                       return std::tuple{at.map, at.receiver, r.any_sun(), at.q,
                                         r.chance(0.1F) ? r.whole(0, 50) : r.modules().step_limit()};
                     })),
  };
}

}  // namespace

std::vector<Row> rows_of_the_papers() {
  std::vector<Row> all;
  for (auto make : {level_of_detail_rows, transit_rows, literal_extrema_rows, literal_rows}) {
    for (Row& row : make()) all.push_back(std::move(row));
  }
  return all;
}

}  // namespace gnomon::modules
