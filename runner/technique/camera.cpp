// SPDX-License-Identifier: MIT
#include "technique/camera.h"

#include <cmath>
#include <numbers>

namespace gnomon::technique {
namespace {

using glm::dvec2;
using glm::dvec3;

/// +z, or north where the view is vertical.
dvec3 right_of(dvec3 forward) {
  constexpr double kVertical = 1e-9;
  const dvec3 right = glm::cross(forward, dvec3(0, 0, 1));
  return glm::length(right) > kVertical ? glm::normalize(right)
                                        : glm::normalize(glm::cross(forward, dvec3(0, 1, 0)));
}

dvec3 vector_of(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

}  // namespace

CameraRays camera_rays(const scene::ViewCamera& camera) {
  CameraRays rays;
  rays.perspective = camera.projection == scene::ViewCamera::Projection::kPerspective;
  rays.eye = vector_of(camera.eye);
  rays.forward = glm::normalize(vector_of(camera.target) - rays.eye);
  const double height =
      rays.perspective ? 2 * std::tan(camera.extent * std::numbers::pi / 360) : camera.extent;
  const double pixel = height / camera.size[1];
  const dvec3 right = right_of(rays.forward);
  rays.right = right * pixel;
  rays.down = glm::cross(rays.forward, right) * pixel;
  rays.middle = dvec2(camera.size[0], camera.size[1]) * 0.5;
  return rays;
}

ViewRay CameraRays::ray(dvec2 at) const {
  const dvec3 aside = right * (at.x - middle.x) + down * (at.y - middle.y);
  return perspective ? ViewRay{eye, forward + aside} : ViewRay{eye + aside, forward};
}

dvec2 CameraRays::project(dvec3 point) const {
  const dvec3 to = point - eye;
  const double scale = perspective ? 1 / glm::dot(to, forward) : 1.0;
  const dvec2 aside(glm::dot(to, right) / glm::dot(right, right), glm::dot(to, down) / glm::dot(down, down));
  return middle + aside * scale;
}

}  // namespace gnomon::technique
