// SPDX-License-Identifier: MIT
// How tests hold what a camera sees against rays and shadows in double precision.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "engine.h"
#include "judge/judge.h"
#include "oracle/view_ray.h"
#include "technique/camera.h"

namespace gnomon::testing {

/// Where a ray meets nothing.
inline constexpr double kNowhere = std::numeric_limits<double>::infinity();

/// Metres along the ray through a point of the image, by oracle::ViewTracer or oracle::MeshTracer.
template <class Tracer>
[[nodiscard]] double true_depth(const Tracer& tracer, const technique::CameraRays& rays, glm::dvec2 at) {
  const technique::ViewRay ray = rays.ray(at);
  const auto hit = tracer.first_hit(
      {{ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z}});
  return hit ? *hit * glm::length(ray.direction) : kNowhere;
}

/// Whether two depths are the same, or `slack` metres apart at most.
[[nodiscard]] inline bool agree(double a, double b, double slack) {
  return a == b || std::abs(a - b) <= slack;
}

/// How much nearer or farther than `depth` the surface may be: 1e-3 of it and the smaller spacing.
[[nodiscard]] inline double depth_slack(double depth, const terrain::HeightMap& map) {
  return (depth < kNowhere ? 1e-3 * depth : 0.0) + std::min(map.spacing_x, map.spacing_y);
}

/// Whether what lies at the pixel's centre stays when the ray moves by 1/50 pixel.
template <class Tracer>
[[nodiscard]] bool is_steady(const Tracer& tracer, const technique::CameraRays& rays, glm::dvec2 centre,
                             double depth, double slack) {
  for (const glm::dvec2 step : {glm::dvec2(0.02, 0), {-0.02, 0}, {0, 0.02}, {0, -0.02}})
    if (!agree(depth, true_depth(tracer, rays, centre + step), slack)) return false;
  return true;
}

/// A scene's image against the oracle at its own columns, rows and levels.
struct Compared {
  Rendered rendered;
  judge::Verdict verdict;
};
[[nodiscard]] inline Result<Compared> compare_with_oracle(Engine& engine, const scene::Scene& scene) {
  Result<Rendered> rendered = engine.render(scene);
  if (!rendered) return rendered.diagnostics();
  const Result<image::Image> reference = engine.reference(scene, rendered->ground);
  if (!reference) return reference.diagnostics();
  judge::Verdict verdict = judge::compare(rendered->image, *reference, {.channels = {"b_shadow", "valid"}});
  return Compared{std::move(rendered).value(), std::move(verdict)};
}

}  // namespace gnomon::testing
