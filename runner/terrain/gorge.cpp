// SPDX-License-Identifier: MIT
// A plateau with a branching, meandering canyon whose walls are terraced, as the Colorado cut it.
#include <algorithm>
#include <cmath>

#include "terrain/generator.h"
#include "terrain/noise.h"

namespace gnomon::terrain {
namespace {

/// A point of a river: metres from the north-west corner, and the river bed's rise above the canyon's mouth
/// as a share of the depth (0 the deepest point, 1 the plateau).
struct RiverPoint {
  double east = 0;
  double south = 0;
  double bed = 0;
};
using River = std::vector<RiverPoint>;

/// Grows rivers; every random choice is the hash of a running number.
class RiverSystem {
 public:
  RiverSystem(const Grid& grid) : grid_(grid), next_(hash(grid.seed)) {}

  std::vector<River> grow() {
    const double width = grid_.width_metres();
    const double height = grid_.height_metres();
    const RiverPoint mouth{-0.05 * width, height * (0.55 + 0.25 * random()), 0.0};
    const RiverPoint spring{1.05 * width, height * (0.2 + 0.25 * random()), 0.12};
    branch(meander(mouth, spring, 7), 0.5 * std::min(width, height), 2);
    return std::move(rivers_);
  }

 private:
  double random() {
    next_ = hash(next_ + 1u);
    return unit(next_);
  }

  /// Midpoint displacement: 2^depth segments between two points, displaced sideways by up to a fifth of their
  /// length.
  River meander(const RiverPoint& from, const RiverPoint& to, int depth) {
    if (depth == 0) return {from, to};
    const double sideways = 0.5 * (random() - 0.5);
    const RiverPoint middle{0.5 * (from.east + to.east) - sideways * (to.south - from.south),
                            0.5 * (from.south + to.south) + sideways * (to.east - from.east),
                            0.5 * (from.bed + to.bed)};
    River river = meander(from, middle, depth - 1);
    const River rest = meander(middle, to, depth - 1);
    river.insert(river.end(), rest.begin() + 1, rest.end());
    return river;
  }

  /// Tributaries join at regular intervals, from alternate sides, against the flow; they end where they reach
  /// the plateau.
  void branch(River river, double length, int generations) {
    const std::size_t interval = river.size() / (generations == 2 ? 11 : 5);
    double side = random() < 0.5 ? -1.0 : 1.0;
    for (std::size_t i = interval; generations > 0 && i + 1 < river.size(); i += interval, side = -side) {
      const RiverPoint& joint = river[i];
      const double upstream_east = river[i + 1].east - river[i - 1].east;
      const double upstream_south = river[i + 1].south - river[i - 1].south;
      const double norm = std::sqrt(upstream_east * upstream_east + upstream_south * upstream_south);
      const double along = (0.2 + 0.6 * random()) / norm;
      const double across = side / norm;
      const double reach = length * (0.6 + 0.4 * random());
      const RiverPoint head{joint.east + reach * (along * upstream_east - across * upstream_south),
                            joint.south + reach * (along * upstream_south + across * upstream_east), 0.95};
      branch(meander(joint, head, generations == 2 ? 6 : 5), 0.45 * length, generations - 1);
    }
    rivers_.push_back(std::move(river));
  }

  const Grid& grid_;
  std::uint32_t next_;
  std::vector<River> rivers_;
};

/// Lowers `valley` (shares of the depth) to a V along one segment: the bed's height plus distance *
/// wall_slope.
void carve(const Grid& grid, const RiverPoint& a, const RiverPoint& b, double wall_slope, Heights& valley) {
  const double reach = (1.0 - std::min(a.bed, b.bed)) / wall_slope;
  const auto first = [&](double metres, double spacing, int size) {
    return static_cast<int>(std::clamp(std::floor((metres - reach) / spacing), 0.0, double(size)));
  };
  const auto last = [&](double metres, double spacing, int size) {
    return static_cast<int>(std::clamp(std::floor((metres + reach) / spacing) + 1.0, 0.0, double(size)));
  };
  const double de = b.east - a.east;
  const double ds = b.south - a.south;
  const double length_squared = de * de + ds * ds;
  const int last_row = last(std::max(a.south, b.south), grid.spacing_y, grid.height);
  const int last_column = last(std::max(a.east, b.east), grid.spacing_x, grid.width);
  for (int row = first(std::min(a.south, b.south), grid.spacing_y, grid.height); row < last_row; ++row)
    for (int column = first(std::min(a.east, b.east), grid.spacing_x, grid.width); column < last_column;
         ++column) {
      const double pe = grid.x(column) - a.east;
      const double ps = grid.southward(row) - a.south;
      const double t =
          length_squared > 0.0 ? std::clamp((pe * de + ps * ds) / length_squared, 0.0, 1.0) : 0.0;
      const double ee = pe - t * de;
      const double ss = ps - t * ds;
      const double share = a.bed + t * (b.bed - a.bed) + std::sqrt(ee * ee + ss * ss) * wall_slope;
      double& value = valley[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width) +
                             static_cast<std::size_t>(column)];
      value = std::min(value, share);
    }
}

/// Cliffs and benches: each layer of rock is a gentle bench that ends in a cliff.
double terrace(double share, double layers) {
  const double layer = std::floor(share * layers);
  const double within = share * layers - layer;
  constexpr double kBench = 0.7;  // share of a layer's width that is bench
  constexpr double kTilt = 0.25;  // share of a layer's height that the bench rises by
  const double rise =
      within < kBench ? within / kBench * kTilt : kTilt + (within - kBench) / (1.0 - kBench) * (1.0 - kTilt);
  return (layer + rise) / layers;
}

/// Gradient noise over several octaves, roughly -1..1.
Heights rough(const Grid& grid, double cell, std::uint32_t seed, int octaves) {
  Heights sum(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), 0.0);
  double amplitude = 0.6;
  for (int k = 0; k < octaves; ++k) {
    const Heights noise = sample_noise(grid, {cell, seed});
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += amplitude * noise[i];
    amplitude *= 0.5;
    cell *= 0.5;
    seed = hash(seed);
  }
  return sum;
}

}  // namespace

Heights gorge(const Grid& grid, const Parameters& parameters) {
  const double side = std::min(grid.width_metres(), grid.height_metres());
  const double depth = parameters.at("depth");
  const double layers = parameters.at("terraces");
  const double wall_slope = 1.0 / (0.1 * side);

  // Beyond 1 the V goes on above the plateau, so that the noise below can widen the canyon as well as narrow
  // it.
  constexpr double kRim = 1.3;
  Heights heights(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height), kRim);
  for (const River& river : RiverSystem(grid).grow())
    for (std::size_t i = 0; i + 1 < river.size(); ++i)
      carve(grid, river[i], river[i + 1], wall_slope, heights);

  const Heights gullies = rough(grid, 0.1 * side, hash(grid.seed ^ 0x67u), 6);
  const Heights plateau = rough(grid, 0.6 * side, hash(grid.seed ^ 0x70u), 5);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double wall = heights[i] + 0.3 * gullies[i] * std::min(1.0, heights[i]);
    const double share = std::clamp(wall, 0.0, 1.0);
    heights[i] = depth * (terrace(share, layers) + 0.06 * plateau[i] * share);
  }
  return heights;
}

}  // namespace gnomon::terrain
