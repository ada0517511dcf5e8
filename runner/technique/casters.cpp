// SPDX-License-Identifier: MIT
#include "technique/casters.h"

#include <algorithm>
#include <optional>

#include "technique/mesh.h"

namespace gnomon::technique {
namespace {

using glm::dvec3;

constexpr int kCells = 64;  ///< a side of what is left out or drawn as one

struct Box {
  dvec3 low{};  ///< metres
  dvec3 high{};
};

/// Holds a part of the grid; absent where no node of it has data.
std::optional<Box> box_of(const Pyramid& pyramid, int step, const gl::Mesh::Part& part) {
  const glm::dvec2 north_west = grid_node(pyramid, step, part.first);
  const glm::dvec2 south_east = grid_node(pyramid, step, part.first + part.cells);
  // The samples around its nodes: those on the map's edge lie half a texel beyond theirs.
  const auto heights = pyramid.height_ranges->over(glm::ivec2(north_west) - 1, glm::ivec2(south_east) + 1);
  if (!heights) return std::nullopt;
  const glm::dvec2 spacing(pyramid.spacing);
  return Box{
      {north_west.x * spacing.x, (double{pyramid.domain.y} - south_east.y) * spacing.y, heights->low},
      {south_east.x * spacing.x, (double{pyramid.domain.y} - north_west.y) * spacing.y, heights->high}};
}

/// Whether the box, seen along an axis, touches from..to metres of it.
bool touches(const Box& box, const dvec3& origin, const dvec3& axis, double from, double to) {
  const double middle = glm::dot(0.5 * (box.low + box.high) - origin, axis);
  const double reach = glm::dot(0.5 * (box.high - box.low), glm::abs(axis));
  return middle + reach >= from && middle - reach <= to;
}

/// A texel, and more than single precision may move a vertex of the map as the sun sees it.
double room_around(const Pyramid& pyramid, const CascadeFit& fit, const CascadeSquare& square) {
  const double across = glm::length(glm::dvec2(pyramid.domain) * glm::dvec2(pyramid.spacing));
  return square.texel + 1e-5 * (fit.range + glm::length(fit.origin) + across);
}

bool casts(const Box& box, const CascadeFit& fit, const CascadeSquare& square, int size, double room) {
  const glm::dvec2 from = square.corner - room, to = square.corner + size * square.texel + room;
  return touches(box, fit.origin, fit.right, from.x, to.x) &&
         touches(box, fit.origin, fit.down, from.y, to.y);
}

/// Adds a part; one that continues the last one eastwards becomes one with it, as draws have a price.
void add(std::vector<gl::Mesh::Part>& parts, const gl::Mesh::Part& part) {
  if (!parts.empty()) {
    gl::Mesh::Part& last = parts.back();
    if (last.first.y == part.first.y && last.first.x + last.cells.x == part.first.x) {
      last.cells.x += part.cells.x;
      return;
    }
  }
  parts.push_back(part);
}

}  // namespace

std::vector<gl::Mesh::Part> casters(const Pyramid& pyramid, const scene::Cascades& cascades,
                                    const CascadeFit& fit, const CascadeSquare& square) {
  const glm::ivec2 cells = grid_cells(pyramid, cascades.step);
  if (!pyramid.height_ranges) return {{.cells = cells}};
  const double room = room_around(pyramid, fit, square);
  std::vector<gl::Mesh::Part> parts;
  for (int y = 0; y < cells.y; y += kCells) {
    for (int x = 0; x < cells.x; x += kCells) {
      const gl::Mesh::Part part{{x, y}, glm::min(glm::ivec2(kCells), cells - glm::ivec2(x, y))};
      const std::optional<Box> box = box_of(pyramid, cascades.step, part);
      if (box && casts(*box, fit, square, cascades.size, room)) add(parts, part);
    }
  }
  return parts;
}

}  // namespace gnomon::technique
