// SPDX-License-Identifier: MIT
// The rays of a perspective or orthographic camera.
#pragma once

#include <glm/glm.hpp>

#include "scene/scene.h"

namespace gnomon::technique {

struct ViewRay {
  glm::dvec3 origin;     ///< metres
  glm::dvec3 direction;  ///< of any length
};

/// The rays of a camera's pixels: perspective from `eye` along forward + aside, orthographic from eye + aside
/// along forward, with aside = (x - middle.x) right + (y - middle.y) down at x, y pixels from the image's
/// upper left corner.
struct CameraRays {
  bool perspective = true;
  glm::dvec3 eye{};      ///< metres
  glm::dvec3 forward{};  ///< unit vector
  glm::dvec3 right{};    ///< a pixel: in lengths of `forward` (perspective) or metres (orthographic)
  glm::dvec3 down{};     ///< likewise
  glm::dvec2 middle{};   ///< pixels

  [[nodiscard]] ViewRay ray(glm::dvec2 at) const;
  /// Where a point of the world appears, pixels from the upper left corner; meaningless behind the eye.
  [[nodiscard]] glm::dvec2 project(glm::dvec3 point) const;
};
[[nodiscard]] CameraRays camera_rays(const scene::ViewCamera& camera);

}  // namespace gnomon::technique
