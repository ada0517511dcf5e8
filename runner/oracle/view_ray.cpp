// SPDX-License-Identifier: MIT
#include "oracle/view_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/patch.h"

namespace gnomon::oracle {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Span {
  double first = 0;
  double last = kInfinity;

  void cut(double origin, double direction, double low, double high) {
    if (direction == 0) {
      if (origin < low || origin > high) last = -1;
      return;
    }
    const auto [near, far] = std::minmax({(low - origin) / direction, (high - origin) / direction});
    first = std::max(first, near);
    last = std::min(last, far);
  }
};

/// The ray in samples of the map: sample j of an axis lies at j.
struct Track {
  double column, row, z;
  double column_rate, row_rate, z_rate;

  Track(const Surface& surface, const ViewRay& ray)
      : column(ray.origin[0] / surface.spacing_x - 0.5),
        row(surface.domain_height - ray.origin[1] / surface.spacing_y - 0.5),
        z(ray.origin[2]),
        column_rate(ray.direction[0] / surface.spacing_x),
        row_rate(-ray.direction[1] / surface.spacing_y),
        z_rate(ray.direction[2]) {}
};

/// The patch with a surface under a track that is over patch (column, row): that one, or one beyond the edge
/// that the track keeps to.
std::optional<PatchIndex> patch_under(const Surface& surface, const Track& track, int column, int row) {
  const auto keeps_to_edge = [](double at, double rate) { return rate == 0 && at == std::floor(at); };
  const int columns = keeps_to_edge(track.column, track.column_rate) ? 2 : 1;
  const int rows = keeps_to_edge(track.row, track.row_rate) ? 2 : 1;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const PatchIndex patch{std::max(column - j, 0), std::max(row - i, 0)};
      if (is_whole(surface, patch)) return patch;
    }
  return std::nullopt;
}

/// The parameter at which a track leaves patch `patch` of an axis.
double leave(double origin, double rate, int patch) {
  if (rate == 0) return kInfinity;
  return ((rate > 0 ? patch : patch - 1) - origin) / rate;
}

/// Where in 0..length a + s (b + c s) grows through 0; negative where nowhere.
double growing_root(double a, double b, double c, double length) {
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return -1;
  const double root = std::sqrt(discriminant);
  const double s = b > 0 ? -2 * a / (b + root) : (root - b) / (2 * c);
  return s >= 0 && s <= length && std::isfinite(s) ? s : -1;
}

}  // namespace

ViewTracer::ViewTracer(const Surface& surface)
    : surface_(surface), highest_(*std::max_element(surface.samples.begin(), surface.samples.end())) {}

std::optional<double> ViewTracer::first_hit(const ViewRay& ray) const {
  const Surface& surface = surface_;
  const Track track(surface, ray);
  Span span;
  span.cut(track.column, track.column_rate, -0.5, surface.domain_width - 0.5);
  span.cut(track.row, track.row_rate, -0.5, surface.domain_height - 0.5);
  span.cut(track.z, track.z_rate, -kInfinity, highest_);
  if (span.first > span.last) return std::nullopt;

  double t = span.first;
  const auto patch_at = [](double position, int samples) {
    return std::clamp(static_cast<int>(std::floor(position)) + 1, 0, samples);
  };
  int column = patch_at(track.column + t * track.column_rate, surface.width);
  int row = patch_at(track.row + t * track.row_rate, surface.height);
  bool begins = true;
  bool above = true;
  bool entered = false;  // from a patch with a surface: `above` is known
  while (t <= span.last) {
    const double exit_x = leave(track.column, track.column_rate, column);
    const double exit_y = leave(track.row, track.row_rate, row);
    const double exit = std::min({exit_x, exit_y, span.last});
    const std::optional<PatchIndex> at = patch_under(surface, track, column, row);
    if (at) {
      const Patch patch(surface, at->column, at->row, 0.0);
      const double x = track.column + t * track.column_rate - (at->column - 1);
      const double y = track.row + t * track.row_rate - (at->row - 1);
      const Profile profile = patch.profile(x, y, track.column_rate, track.row_rate);
      const double clearance = patch.height(x, y) - (track.z + t * track.z_rate);
      if (begins && clearance > 0) return std::nullopt;  // inside the ground
      if (!entered) above = clearance <= 0;
      if (entered && above && clearance > 0) return t;  // rounding at the common edge
      const double slope = profile.linear - track.z_rate;
      const double length = std::isfinite(exit) ? std::max(exit - t, 0.0) : kInfinity;
      const double s = growing_root(clearance, slope, profile.quadratic, length);
      if (s >= 0) return t + s;
      above = std::isfinite(exit) && clearance + length * (slope + profile.quadratic * length) <= 0;
    }
    if (!std::isfinite(exit) || exit == span.last) break;  // vertical, and not over the surface; or the end
    begins = begins && exit <= t;
    // Beyond a hole the entry says anew on which side of the sheet the ray is. A patch of length 0 changes
    // nothing.
    if (exit > t || !at) entered = at.has_value();
    t = std::max(t, exit);
    if (exit_x == exit) column += track.column_rate > 0 ? 1 : -1;
    if (exit_y == exit) row += track.row_rate > 0 ? 1 : -1;
    if (column < 0 || row < 0 || column > surface.width || row > surface.height) break;
  }
  return std::nullopt;
}

}  // namespace gnomon::oracle
