// SPDX-License-Identifier: MIT
#include "oracle/oracle.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <system_error>
#include <thread>

#include "oracle/block_maxima.h"
#include "oracle/horizon_search.h"
#include "oracle/patch.h"

namespace gnomon::oracle {
namespace {

// Dividing first keeps 45, 90 and their like exact.
double radians(double degrees) {
  return degrees / 180 * std::numbers::pi;
}

bool in_domain(const Surface& surface, const Receiver& receiver) {
  return receiver.column >= 0 && receiver.column <= surface.domain_width && receiver.row >= 0 &&
         receiver.row <= surface.domain_height;
}

double search(const Surface& surface, const Receiver& receiver, GroundDirection towards_sun,
              const BlockMaxima* blocks) {
  if (!in_domain(surface, receiver)) return -std::numeric_limits<double>::infinity();
  return HorizonSearch(surface, receiver, towards_sun, blocks).run();
}

// Runs work(first, last) over chunks of 0 .. count on `threads` threads, this one included. Chunks are handed
// out one by one, for rays differ widely in cost; each result has its own place, so their order does not
// matter.
template <typename Work>
void for_each_chunk(std::size_t count, int threads, const Work& work) {
  constexpr std::size_t kChunk = 512;
  std::atomic<std::size_t> next = 0;
  const auto drain = [&] {
    for (std::size_t first = next.fetch_add(kChunk); first < count; first = next.fetch_add(kChunk)) {
      work(first, std::min(first + kChunk, count));
    }
  };
  std::vector<std::jthread> helpers;
  const auto chunks = (count + kChunk - 1) / kChunk;
  try {
    for (std::size_t i = 1; i < std::min(static_cast<std::size_t>(threads), chunks); ++i)
      helpers.emplace_back(drain);
  } catch (const std::system_error&) {
    // The system grants no more threads: those that run, this one at the least, do all the work.
  }
  drain();
}

}  // namespace

GroundDirection ground_direction(double azimuth_degrees) {
  int quarter_turns = 0;  // its low bits count, whatever the sign
  const double rest = std::remquo(azimuth_degrees, 90.0, &quarter_turns);
  const bool diagonal = std::abs(rest) == 45;
  const double along = diagonal ? std::sqrt(0.5) : std::cos(radians(rest));
  const double across = diagonal ? std::copysign(along, rest) : std::sin(radians(rest));
  switch (quarter_turns & 3) {
    case 0:
      return {across, along};
    case 1:
      return {along, -across};
    case 2:
      return {-across, -along};
    default:
      return {-along, across};
  }
}

bool has_surface(const Surface& surface, double column, double row) {
  return in_domain(surface, {column, row, 0}) && ground_patch(surface, column - 0.5, row - 0.5).has_value();
}

double surface_height(const Surface& surface, double column, double row) {
  const double x = std::fmin(std::fmax(column, 0.0), surface.width) - 0.5;
  const double y = std::fmin(std::fmax(row, 0.0), surface.height) - 0.5;
  const double west = std::floor(x);
  const double north = std::floor(y);
  const Patch patch(surface, static_cast<int>(west) + 1, static_cast<int>(north) + 1, 0.0);
  return patch.height(x - west, y - north);
}

double horizon_slope(const Surface& surface, const Receiver& receiver, GroundDirection towards_sun) {
  return search(surface, receiver, towards_sun, nullptr);
}

std::vector<double> horizons(const Surface& surface, std::span<const Receiver> receivers,
                             GroundDirection towards_sun, int threads) {
  if (threads <= 0) threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const BlockMaxima blocks(surface);
  std::vector<double> result(receivers.size());
  for_each_chunk(receivers.size(), threads, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      result[i] = std::atan(search(surface, receivers[i], towards_sun, &blocks));
    }
  });
  return result;
}

bool in_shadow(double horizon_radians, double elevation_degrees) {
  if (elevation_degrees <= 0) return true;
  if (elevation_degrees >= 90) return false;
  return horizon_radians > radians(elevation_degrees);
}

double band_width(bool on_samples_of_base_map, double receiver_height, double steepest_slope) {
  return on_samples_of_base_map && receiver_height == 0 && steepest_slope <= 50 ? 1e-5 : 1e-4;
}

bool in_band(double horizon_radians, double elevation_degrees, double band_width_radians) {
  if (elevation_degrees <= 0 || elevation_degrees >= 90) return false;
  return std::abs(horizon_radians - radians(elevation_degrees)) < band_width_radians;
}

double steepest_slope(const Surface& surface) {
  const auto at = [&](int row, int column) {
    return static_cast<double>(
        surface.samples[static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.width) +
                        static_cast<std::size_t>(column)]);
  };
  double steepest = 0;
  for (int row = 0; row < surface.height; ++row) {
    for (int column = 0; column < surface.width; ++column) {
      const double here = at(row, column);
      const auto slope_to = [&](double other, double distance) {
        return std::min(here, other) > Surface::kNoData ? std::abs(here - other) / distance : 0.0;
      };
      if (column > 0) steepest = std::max(steepest, slope_to(at(row, column - 1), surface.spacing_x));
      if (row > 0) steepest = std::max(steepest, slope_to(at(row - 1, column), surface.spacing_y));
    }
  }
  return steepest;
}

}  // namespace gnomon::oracle
