// SPDX-License-Identifier: MIT
#include "trace/point.h"

#include <algorithm>

#include "image/image.h"
#include "oracle/mesh_ray.h"
#include "oracle/view_ray.h"
#include "technique/camera.h"
#include "technique/surface.h"
#include "terrain/level.h"
#include "trace/pixel_modules.h"

namespace gnomon::trace {
namespace {

using technique::Ground;

std::optional<Diagnostic> no_such_pixel(glm::ivec2 pixel, glm::ivec2 size) {
  if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < size.x && pixel.y < size.y) return std::nullopt;
  return Diagnostic{.file = "--pixel",
                    .message = "the image has no pixel (" + std::to_string(pixel.x) + ", " +
                               std::to_string(pixel.y) + "); it has the columns 0 to " +
                               std::to_string(size.x - 1) + " and the rows 0 to " +
                               std::to_string(size.y - 1) + ", counted from its upper left corner"};
}

/// One pixel of an image's ground.
Ground alone(const Ground& ground, glm::ivec2 pixel) {
  const std::size_t i = ground.index(pixel);
  Ground one{.size = {1, 1}, .texels_per_pixel = ground.texels_per_pixel};
  one.column = {ground.column[i]};
  one.row = {ground.row[i]};
  one.valid = {ground.valid[i]};
  one.q = {ground.q[i]};
  if (!ground.depth.empty()) one.depth = {ground.depth[i]};
  return one;
}

/// The ray of programs/view.frag, whose numbers are single ones.
struct PixelRay {
  PixelRay(const technique::CameraRays& rays, glm::ivec2 pixel)
      : right(rays.right), down(rays.down), perspective(rays.perspective) {
    const glm::vec2 from_middle = glm::vec2(pixel) + 0.5F - glm::vec2(rays.middle);
    const glm::vec3 aside = right * from_middle.x + down * from_middle.y;
    origin = perspective ? glm::vec3(rays.eye) : glm::vec3(rays.eye) + aside;
    direction = perspective ? glm::vec3(rays.forward) + aside : glm::vec3(rays.forward);
  }
  glm::vec3 origin{}, direction{}, right, down;
  bool perspective;
};

float level_at(const PixelModules& modules, const Modules::GnomonHit& hit, const PixelRay& ray,
               const scene::Shadow& shadow, int coarsest) {
  if (shadow.q) return static_cast<float>(*shadow.q);
  const Modules::GnomonMap map = modules.map();
  const glm::vec3 normal =
      modules.gnomon_surface_normal(map, modules.gnomon_receiver_at(hit.at.x, hit.at.y, 0), 0);
  const float apart = ray.perspective ? hit.depth : 1.0F;
  return static_cast<float>(
      modules.gnomon_level_of_detail(modules.gnomon_footprint(map, normal, ray.direction, ray.right * apart),
                                     modules.gnomon_footprint(map, normal, ray.direction, ray.down * apart),
                                     static_cast<float>(shadow.max_anisotropy), coarsest));
}

oracle::ViewRay oracle_ray(const technique::ViewRay& ray) {
  return {{ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z}};
}

/// Column and row of origin + t * direction.
std::array<double, 2> place_of(const terrain::HeightMap& base, const technique::ViewRay& ray, double t) {
  const glm::dvec3 at = ray.origin + t * ray.direction;
  return {std::clamp(at.x / base.spacing_x, 0.0, base.domain_width),
          std::clamp(base.domain_height - at.y / base.spacing_y, 0.0, base.domain_height)};
}

std::optional<std::array<double, 2>> oracle_hit(const terrain::HeightMap& base,
                                                const technique::CameraRays& rays, glm::ivec2 pixel) {
  const technique::ViewRay ray = rays.ray(glm::dvec2(pixel) + 0.5);
  const oracle::Surface surface = technique::surface_of(base);
  const auto hit = oracle::ViewTracer(surface).first_hit(oracle_ray(ray));
  if (!hit) return std::nullopt;
  return place_of(base, ray, *hit);
}

Result<Point> seen(const scene::ViewCamera& camera, const scene::Shadow& shadow,
                   const terrain::HeightMap& base, glm::ivec2 pixel) {
  const PixelModules modules(base, 0);
  const technique::CameraRays rays = technique::camera_rays(camera);
  const PixelRay ray(rays, pixel);
  const Modules::GnomonHit hit =
      modules.gnomon_relief_view(modules.map(), ray.origin, ray.direction, 0, modules.step_limit());
  if (hit.cause == GNOMON_VIEW_UNDECIDED)
    return Diagnostic{.message =
                          "the view ray of this pixel reached its bound of steps; this is a fault of "
                          "gnomon, please report it with this scene",
                      .failure = Failure::kFailed};
  Point point{.ground = technique::empty_ground({1, 1}, shadow),
              .image_size = {camera.size[0], camera.size[1]}};
  const float depth = hit.depth * glm::length(ray.direction);
  point.view = ViewHit{depth, hit.steps, oracle_hit(base, rays, pixel)};
  point.ground.depth = {depth};
  point.ground.column = {hit.at.x};
  point.ground.row = {hit.at.y};
  if (hit.cause != GNOMON_VIEW_SURFACE) return point;
  point.ground.valid = {1.0F};
  point.ground.q = {level_at(modules, hit, ray, shadow, terrain::coarsest_level(base.width, base.height))};
  return point;
}

/// Triangles are drawn by the GPU alone: here rays in double precision meet them, a last bit beside.
Point seen_of_mesh(const scene::ViewCamera& camera, const scene::Shadow& shadow,
                   const terrain::HeightMap& base, glm::ivec2 pixel) {
  const technique::ViewRay ray = technique::camera_rays(camera).ray(glm::dvec2(pixel) + 0.5);
  const oracle::Surface surface = technique::surface_of(base);
  const auto hit = oracle::MeshTracer(surface, camera.mesh->step, camera.mesh->cull_back_faces)
                       .first_triangle(oracle_ray(ray));
  Point point{.ground = technique::reference_pixel(base, camera, shadow, pixel),
              .image_size = {camera.size[0], camera.size[1]},
              .mesh = MeshView{}};
  if (!hit) return point;
  point.mesh = {
      hit->t * glm::length(ray.direction),
      Triangle{
          place_of(base, ray, hit->t), {hit->west, hit->east}, {hit->north, hit->south}, hit->north_western}};
  return point;
}

Result<Point> of_image(const Result<Ground>& ground, glm::ivec2 pixel) {
  if (!ground) return ground.diagnostics();
  if (const auto wrong = no_such_pixel(pixel, ground->size)) return *wrong;
  return Point{.ground = alone(*ground, pixel), .image_size = ground->size};
}

Result<Point> any_point_of(const scene::Scene& scene, const terrain::HeightMap& base, glm::ivec2 pixel) {
  if (const auto* map = std::get_if<scene::MapCamera>(&scene.camera))
    return of_image(technique::map_ground(*map, scene.shadow, base), pixel);
  if (const auto* points = std::get_if<scene::PointsCamera>(&scene.camera)) {
    const Result<image::Image> image = image::read_image(points->path);
    if (!image) return image.diagnostics();
    return of_image(technique::points_ground(*image, points->path, scene.shadow, base), pixel);
  }
  const auto& camera = std::get<scene::ViewCamera>(scene.camera);
  if (const auto wrong = no_such_pixel(pixel, {camera.size[0], camera.size[1]})) return *wrong;
  if (camera.mesh) return seen_of_mesh(camera, scene.shadow, base, pixel);
  return seen(camera, scene.shadow, base, pixel);
}

}  // namespace

Result<Point> point_of(const scene::Scene& scene, const terrain::HeightMap& base, glm::ivec2 pixel) {
  Result<Point> point = any_point_of(scene, base, pixel);
  if (point) technique::leave_out_holes(point->ground, base);
  return point;
}

}  // namespace gnomon::trace
