// SPDX-License-Identifier: MIT
#include "technique/point_list.h"

#include <algorithm>

#include "technique/tiles.h"

namespace gnomon::technique {
namespace {

/// Texels a side of the squares that groups lie in.
constexpr int kSquare = 8;
constexpr std::size_t kTexels = std::size_t{kSquare} * kSquare;
constexpr int kMostSquares = kTile / kSquare;  ///< across a list
/// A picture of 1920 x 1080 fits where its levels lie in areas, as they do: what is left over for a list of
/// its own takes long, as little of it is drawn at once.
constexpr int kMostRows = 2 * kTile + kTile / 8;

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

/// Places in a square of kSquare x kSquare along a Z curve: neighbours in it are neighbours in the square,
/// and its groups of 8, 16 and 32 are rectangles of 4 x 2, 4 x 4 and 8 x 4.
glm::ivec2 on_z_curve(std::size_t k) {
  return {(k & 1) | (k >> 1 & 2) | (k >> 2 & 4), (k >> 1 & 1) | (k >> 2 & 2) | (k >> 3 & 4)};
}

/// Adds pixels that close up, in whole squares.
void add_loose(const Pixels& loose, Pixels& squares) {
  for (std::size_t first = 0; first < loose.size(); first += kTexels) {
    squares.resize(squares.size() + kTexels, loose.back());
    for (std::size_t k = 0; k < std::min(kTexels, loose.size() - first); ++k) {
      const glm::ivec2 at = on_z_curve(k);
      squares[squares.size() - kTexels + static_cast<std::size_t>(at.y * kSquare + at.x)] = loose[first + k];
    }
  }
}

/// The upper left pixels of an image's squares, those of a district of 8 x 8 one after the other: pixels that
/// close up come from near each other.
std::vector<glm::ivec2> squares_of(glm::ivec2 image) {
  constexpr int kDistrict = kSquare * kSquare;
  std::vector<glm::ivec2> squares;
  for (int north = 0; north < image.y; north += kDistrict) {
    for (int west = 0; west < image.x; west += kDistrict) {
      for (std::size_t k = 0; k < kTexels; ++k) {
        const glm::ivec2 first = glm::ivec2(west, north) + on_z_curve(k) * kSquare;
        if (first.x < image.x && first.y < image.y) squares.push_back(first);
      }
    }
  }
  return squares;
}

/// Adds a square whose pixels keep their places; a neighbour stands in for one that is missing, as its
/// walk holds up none beside it.
void add_square(const std::vector<Place>& asking, Pixels& squares) {
  std::size_t next = 0, pixel = asking.front().pixel;
  for (std::size_t texel = 0; texel < kTexels; ++texel) {
    if (next < asking.size() && asking[next].texel == texel) pixel = asking[next++].pixel;
    squares.push_back(pixel);
  }
}

/// The pixels that ask for level q, square after square. Those of a square keep their places in it where they
/// fill most of it: one that is missing must not move all that follow out of their groups. The others close
/// up.
Pixels in_squares(const Ground& ground, int q) {
  Pixels squares, loose;
  std::vector<Place> asking;
  for (const glm::ivec2 square : squares_of(ground.size)) {
    find_asking(ground, q, square, asking);
    if (2 * asking.size() > kTexels) {
      add_square(asking, squares);
    } else {
      for (const Place& place : asking) loose.push_back(place.pixel);
    }
  }
  add_loose(loose, squares);
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
      if (lists.empty() || size_of(lists.back()).y == kMostRows) lists.emplace_back();
      const int row = size_of(lists.back()).y;
      // A band is one draw, which must not take longer than that of a tile.
      const std::size_t room = static_cast<std::size_t>(std::min(kMostRows - row, kTile)) * kTile;
      const Pixels::iterator end = rest.begin() + static_cast<std::ptrdiff_t>(std::min(room, rest.size()));
      lists.back().push_back(band_of(q, Pixels(rest.begin(), end), row));
      rest.erase(rest.begin(), end);
    }
  }
  return lists;
}

}  // namespace gnomon::technique
