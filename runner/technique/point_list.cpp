// SPDX-License-Identifier: MIT
#include "technique/point_list.h"

#include <algorithm>

#include "technique/tiles.h"

namespace gnomon::technique {
namespace {

/// Texels a side of the squares that groups lie in.
constexpr int kSquare = 8;
constexpr std::size_t kTexels = std::size_t{kSquare} * kSquare;
constexpr int kMostSquares = kTile / kSquare;  ///< on a side of a list

using Pixels = std::vector<std::size_t>;

struct Place {
  std::size_t texel;  ///< of the square
  std::size_t pixel;  ///< of the image
};

/// The pixels of the square of the image at `first` that ask for level q.
void find_asking(const Ground& ground, int q, glm::ivec2 first, std::vector<Place>& asking) {
  asking.clear();
  const glm::ivec2 end = glm::min(first + kSquare, ground.size);
  for (int y = first.y; y < end.y; ++y) {
    for (int x = first.x; x < end.x; ++x) {
      const std::size_t pixel = ground.index({x, y});
      if (ground.valid[pixel] == 0 || static_cast<int>(ground.q[pixel]) != q) continue;
      asking.push_back({static_cast<std::size_t>((y - first.y) * kSquare + x - first.x), pixel});
    }
  }
}

/// The upper left pixels of an image's squares, those of a district one after the other: pixels that close up
/// come from near each other.
std::vector<glm::ivec2> squares_of(glm::ivec2 image) {
  constexpr int kDistrict = 8 * kSquare;
  std::vector<glm::ivec2> squares;
  for (int north = 0; north < image.y; north += kDistrict)
    for (int west = 0; west < image.x; west += kDistrict)
      for (int y = north; y < std::min(north + kDistrict, image.y); y += kSquare)
        for (int x = west; x < std::min(west + kDistrict, image.x); x += kSquare) squares.emplace_back(x, y);
  return squares;
}

/// The pixels that ask for level q, square after square. Those of a square keep their places in it where they
/// fill half of it: one that is missing must not move all that follow out of their groups. The others close
/// up.
Pixels in_squares(const Ground& ground, int q) {
  Pixels squares, loose;
  std::vector<Place> asking;
  for (const glm::ivec2 square : squares_of(ground.size)) {
    find_asking(ground, q, square, asking);
    if (2 * asking.size() < kTexels) {
      for (const Place& place : asking) loose.push_back(place.pixel);
      continue;
    }
    squares.resize(squares.size() + kTexels, asking.front().pixel);
    for (const Place& place : asking) squares[squares.size() - kTexels + place.texel] = place.pixel;
  }
  squares.insert(squares.end(), loose.begin(), loose.end());
  if (!squares.empty()) squares.resize((squares.size() + kTexels - 1) / kTexels * kTexels, squares.back());
  return squares;
}

int ceil_div(int a, int b) {
  return (a + b - 1) / b;
}

/// A band of these squares' pixels, `row` texels down its list.
Band band_of(int q, const Pixels& in_squares, int row) {
  const int squares = static_cast<int>(in_squares.size() / kTexels);
  const int rows = ceil_div(squares, kMostSquares), columns = ceil_div(squares, rows);
  Band band{.q = q, .window = {{0, row}, glm::ivec2(columns, rows) * kSquare}};
  band.pixels.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) * kTexels,
                     in_squares.back());
  const auto across = static_cast<std::size_t>(columns);
  for (std::size_t i = 0; i < in_squares.size(); ++i) {
    const std::size_t square = i / kTexels, texel = i % kTexels;
    const std::size_t y = square / across * kSquare + texel / kSquare;
    const std::size_t x = square % across * kSquare + texel % kSquare;
    band.pixels[y * across * kSquare + x] = in_squares[i];
  }
  return band;
}

}  // namespace

glm::ivec2 size_of(const PointList& list) {
  glm::ivec2 size(0);
  for (const Band& band : list) size = glm::max(size, band.window.first + band.window.size);
  return size;
}

std::vector<PointList> point_lists(const Ground& ground, const std::set<int>& levels) {
  std::vector<PointList> lists;
  for (const int q : levels) {
    Pixels rest = in_squares(ground, q);
    while (!rest.empty()) {
      if (lists.empty() || size_of(lists.back()).y == kTile) lists.emplace_back();
      const int row = size_of(lists.back()).y;
      const std::size_t room = static_cast<std::size_t>(kTile - row) * kTile;
      const Pixels::iterator end = rest.begin() + static_cast<std::ptrdiff_t>(std::min(room, rest.size()));
      lists.back().push_back(band_of(q, Pixels(rest.begin(), end), row));
      rest.erase(rest.begin(), end);
    }
  }
  return lists;
}

}  // namespace gnomon::technique
