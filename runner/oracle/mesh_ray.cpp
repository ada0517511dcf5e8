// SPDX-License-Identifier: MIT
#include "oracle/mesh_ray.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gnomon::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::vector<double> nodes(int samples, double domain, int step) {
  std::vector<double> at{0.0};
  for (int sample = 0; sample < samples - 1; sample += step) at.push_back(std::min(sample + 0.5, domain));
  at.push_back(std::min(samples - 0.5, domain));
  at.push_back(domain);
  return at;
}

/// The last cell that begins at or before `at`.
int cell_at(const std::vector<double>& nodes, double at) {
  const auto after = std::upper_bound(nodes.begin(), nodes.end(), at);
  return std::clamp(static_cast<int>(after - nodes.begin()) - 1, 0, static_cast<int>(nodes.size()) - 2);
}

/// Whether a node at (x, y), texels, has a height: a sample has one of its own.
bool has_height(const Surface& surface, double x, double y) {
  const double column = x - 0.5, row = y - 0.5;
  if (column != std::floor(column) || row != std::floor(row)) return has_surface(surface, x, y);
  const auto at = static_cast<std::size_t>(row) * static_cast<std::size_t>(surface.width) +
                  static_cast<std::size_t>(column);
  return surface.samples[at] > Surface::kNoData;
}

/// The part of the ray in which an axis lies in low .. high.
void cut(double origin, double rate, double low, double high, double& first, double& last) {
  if (rate == 0) {
    if (origin < low || origin > high) last = -1;
    return;
  }
  const auto [near, far] = std::minmax({(low - origin) / rate, (high - origin) / rate});
  first = std::max(first, near);
  last = std::min(last, far);
}

}  // namespace

/// The ray in texels and metres.
struct MeshTracer::Track {
  double column, row, z;
  double column_rate, row_rate, z_rate;
};

MeshTracer::MeshTracer(const Surface& surface, int step, bool cull_back_faces)
    : surface_(surface),
      cull_back_faces_(cull_back_faces),
      highest_(*std::max_element(surface.samples.begin(), surface.samples.end())),
      columns_(nodes(surface.width, surface.domain_width, step)),
      rows_(nodes(surface.height, surface.domain_height, step)) {}

std::optional<MeshHit> MeshTracer::hit_in_cell(const Track& track, int column, int row, double from,
                                               double to) const {
  const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
  const double x0 = columns_[c], x1 = columns_[c + 1], y0 = rows_[r], y1 = rows_[r + 1];
  if (x1 <= x0 || y1 <= y0) return std::nullopt;
  std::optional<MeshHit> nearest;
  for (const bool first : {true, false}) {
    // The corner off the diagonal, and the ends of the diagonal beside and above or below it.
    const double cx = first ? x0 : x1, cy = first ? y0 : y1;
    const double beside_x = first ? x1 : x0, beside_y = first ? y1 : y0;
    if (!has_height(surface_, cx, cy) || !has_height(surface_, beside_x, cy) ||
        !has_height(surface_, cx, beside_y))
      continue;
    const double corner = surface_height(surface_, cx, cy);
    const double slope_x = (surface_height(surface_, beside_x, cy) - corner) / (beside_x - cx);
    const double slope_y = (surface_height(surface_, cx, beside_y) - corner) / (beside_y - cy);
    const double above = track.z - corner - slope_x * (track.column - cx) - slope_y * (track.row - cy);
    const double rate = track.z_rate - slope_x * track.column_rate - slope_y * track.row_rate;
    if (rate == 0 || (rate > 0 && cull_back_faces_)) continue;
    const double t = -above / rate;
    const double rounding = 1e-12 * (1 + std::abs(t));  // at a common edge a ray may not slip through
    if (t < from - rounding || t > to + rounding || t < 0) continue;
    const double x = track.column + t * track.column_rate, y = track.row + t * track.row_rate;
    const double along = (x - x0) / (x1 - x0) + (y - y0) / (y1 - y0);
    if (first ? along > 1 + 1e-12 : along < 1 - 1e-12) continue;
    const double inside_x = std::clamp(x, 0.0, surface_.domain_width);
    const double inside_y = std::clamp(y, 0.0, surface_.domain_height);
    if (!has_surface(surface_, inside_x, inside_y)) continue;
    if (nearest && nearest->t <= t) continue;
    nearest = {.t = t, .west = x0, .east = x1, .north = y0, .south = y1, .north_western = first};
  }
  return nearest;
}

std::optional<double> MeshTracer::first_hit(const ViewRay& ray) const {
  const std::optional<MeshHit> hit = first_triangle(ray);
  return hit ? std::optional(hit->t) : std::nullopt;
}

std::optional<MeshHit> MeshTracer::first_triangle(const ViewRay& ray) const {
  const Track track{.column = ray.origin[0] / surface_.spacing_x,
                    .row = surface_.domain_height - ray.origin[1] / surface_.spacing_y,
                    .z = ray.origin[2],
                    .column_rate = ray.direction[0] / surface_.spacing_x,
                    .row_rate = -ray.direction[1] / surface_.spacing_y,
                    .z_rate = ray.direction[2]};
  double t = 0, last = kInfinity;
  cut(track.column, track.column_rate, 0, surface_.domain_width, t, last);
  cut(track.row, track.row_rate, 0, surface_.domain_height, t, last);
  cut(track.z, track.z_rate, -kInfinity, highest_, t, last);
  if (t > last) return std::nullopt;
  int column = cell_at(columns_, track.column + t * track.column_rate);
  int row = cell_at(rows_, track.row + t * track.row_rate);
  while (column >= 0 && row >= 0 && column + 1 < static_cast<int>(columns_.size()) &&
         row + 1 < static_cast<int>(rows_.size())) {
    const auto exit = [](const std::vector<double>& nodes, int cell, double origin, double rate) {
      if (rate == 0) return kInfinity;
      return (nodes[static_cast<std::size_t>(rate > 0 ? cell + 1 : cell)] - origin) / rate;
    };
    const double exit_x = exit(columns_, column, track.column, track.column_rate);
    const double exit_y = exit(rows_, row, track.row, track.row_rate);
    const double to = std::min({exit_x, exit_y, last});
    if (const auto hit = hit_in_cell(track, column, row, t, to)) return hit;
    if (to >= last) break;
    t = std::max(t, to);
    if (exit_x <= to) column += track.column_rate > 0 ? 1 : -1;
    if (exit_y <= to) row += track.row_rate > 0 ? 1 : -1;
  }
  return std::nullopt;
}

}  // namespace gnomon::oracle
