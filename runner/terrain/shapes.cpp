// SPDX-License-Identifier: MIT
// Surfaces whose shadows have a closed form (docs/algorithms.md, "Analytic ground truths"), and stress maps.
#include <algorithm>
#include <cmath>

#include "terrain/generator.h"
#include "terrain/noise.h"

namespace gnomon::terrain {
namespace {

/// Distance in metres from a point of the domain, given in texels from its west and north edges.
double distance(const Grid& grid, int row, int column, double centre_row, double centre_column) {
  const double dx = (column + 0.5 - centre_column) * grid.spacing_x;
  const double dy = (row + 0.5 - centre_row) * grid.spacing_y;
  return std::sqrt(dx * dx + dy * dy);
}

double cone_height(double height, double radius, double from_axis) {
  return from_axis < radius ? height * (1.0 - from_axis / radius) : 0.0;
}

}  // namespace

Heights flat(const Grid& grid, const Parameters& parameters) {
  return Heights(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                 parameters.at("height"));
}

Heights plane(const Grid& grid, const Parameters& parameters) {
  const double slope_x = parameters.at("slope_x");
  const double slope_y = parameters.at("slope_y");
  return fill(grid, [&](int row, int column) {
    return slope_x * grid.x(column) + slope_y * (grid.height_metres() - grid.southward(row));
  });
}

Heights wall(const Grid& grid, const Parameters& parameters) {
  const double west = parameters.at("column");
  const double east = west + parameters.at("thickness");
  const double height = parameters.at("height");
  return fill(grid,
              [&](int, int column) { return column + 0.5 > west && column + 0.5 < east ? height : 0.0; });
}

Heights step(const Grid& grid, const Parameters& parameters) {
  const double edge = parameters.at("column");
  const double height = parameters.at("height");
  return fill(grid, [&](int, int column) { return column + 0.5 < edge ? height : 0.0; });
}

Heights steps(const Grid& grid, const Parameters& parameters) {
  const double treads = parameters.at("count") + 1.0;
  const double rise = parameters.at("rise");
  return fill(grid, [&](int, int column) {
    const double tread = std::floor((column + 0.5) * treads / grid.width);
    return rise * (treads - 1.0 - tread);
  });
}

Heights cone(const Grid& grid, const Parameters& parameters) {
  const double height = parameters.at("height");
  const double radius = parameters.at("radius");
  return fill(grid, [&](int row, int column) {
    return cone_height(height, radius,
                       distance(grid, row, column, parameters.at("row"), parameters.at("column")));
  });
}

Heights spikes(const Grid& grid, const Parameters& parameters) {
  const double height = parameters.at("height");
  const double radius = parameters.at("radius");
  // A quincunx, each spike moved by up to 1/16 of the map, with its tip on a sample so that it has its full
  // height.
  constexpr double kPlaces[5][2] = {{0.25, 0.25}, {0.75, 0.25}, {0.5, 0.5}, {0.25, 0.75}, {0.75, 0.75}};
  struct Tip {
    double column, row;
  };
  std::vector<Tip> tips;
  for (int k = 0; k < 5; ++k) {
    const auto moved = [&](double place, int size, std::int64_t axis) {
      return std::floor((place + (unit(hash(grid.seed, k, axis)) - 0.5) / 8.0) * size) + 0.5;
    };
    tips.push_back({moved(kPlaces[k][0], grid.width, 0), moved(kPlaces[k][1], grid.height, 1)});
  }
  return fill(grid, [&](int row, int column) {
    double highest = 0.0;
    for (const Tip& tip : tips)
      highest =
          std::max(highest, cone_height(height, radius, distance(grid, row, column, tip.row, tip.column)));
    return highest;
  });
}

Heights posts(const Grid& grid, const Parameters& parameters) {
  const int pitch = static_cast<int>(parameters.at("pitch"));
  const double height = parameters.at("height");
  return fill(grid, [&](int row, int column) {
    // One post at a hashed place in each square of pitch x pitch samples.
    const std::uint32_t hashed = hash(grid.seed, column / pitch, row / pitch);
    const int post_column = static_cast<int>(unit(hashed) * pitch);
    const int post_row = static_cast<int>(unit(hash(hashed)) * pitch);
    return column % pitch == post_column && row % pitch == post_row ? height : 0.0;
  });
}

Heights crater(const Grid& grid, const Parameters& parameters) {
  const double radius = parameters.at("radius");
  const double curvature = parameters.at("depth") / (radius * radius);
  return fill(grid, [&](int row, int column) {
    const double r = distance(grid, row, column, parameters.at("row"), parameters.at("column"));
    return r < radius ? curvature * (r * r - radius * radius) : 0.0;
  });
}

Heights checker(const Grid& grid, const Parameters& parameters) {
  const int cell = static_cast<int>(parameters.at("cell"));
  const double height = parameters.at("height");
  return fill(grid,
              [&](int row, int column) { return (row / cell + column / cell) % 2 == 0 ? height : 0.0; });
}

}  // namespace gnomon::terrain
