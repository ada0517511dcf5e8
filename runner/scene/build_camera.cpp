// SPDX-License-Identifier: MIT
#include "scene/build_camera.h"

#include <cmath>

#include "scene/values.h"

namespace gnomon::scene {
namespace {

using json::Value;

constexpr const char* kPerspective = "perspective";
constexpr const char* kOrthographic = "orthographic";

std::array<double, 3> point(const Value& value) {
  return {value.array()[0].number(), value.array()[1].number(), value.array()[2].number()};
}

constexpr double kNearestTarget = 1e-6;  // metres

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

MapCamera read_map(const Value& value) {
  MapCamera camera;
  if (const Value* size = value.find("size")) camera.size = integer_pair_of(*size);
  return camera;
}

std::optional<MeshSurface> read_surface(const Value& value) {
  if (value.get_if<std::string>()) {
    return value.text() == "mesh" ? std::optional(MeshSurface{}) : std::nullopt;
  }
  const Value& mesh = *value.find("mesh");
  MeshSurface surface;
  if (const Value* step = mesh.find("step")) surface.step = integer_of(*step);
  if (const Value* cull = mesh.find("cull_back_faces")) surface.cull_back_faces = std::get<bool>(cull->data);
  return surface;
}

ViewCamera read_view(const Value& value, ViewCamera::Projection projection, Report& report) {
  const bool perspective = projection == ViewCamera::Projection::kPerspective;
  ViewCamera camera{
      .projection = projection, .eye = point(*value.find("eye")), .target = point(*value.find("target"))};
  if (const Value* extent = value.find(perspective ? "fov" : "height")) camera.extent = extent->number();
  if (const Value* size = value.find("size")) camera.size = integer_pair_of(*size);
  if (const Value* samples = value.find("samples")) camera.samples = integer_of(*samples);
  if (const Value* surface = value.find("surface")) camera.mesh = read_surface(*surface);
  if (distance(camera.eye, camera.target) < kNearestTarget) {
    report.error(value.find("target")->place,
                 std::string("/camera/") + (perspective ? kPerspective : kOrthographic) + "/target",
                 "the target is the eye itself; expected a point in the middle of the image, a micrometre or "
                 "more away");
  }
  return camera;
}

PointsCamera read_points(const Value& value, const BuildContext& context, Report& report) {
  const InsideFile inside = inside_file(*value.find("file"), "/camera/points/file", context, report);
  return {inside.path, inside.below_root};
}

Value canonical_surface(const MeshSurface& surface) {
  Value mesh{json::Object{}};
  mesh.set("step", {std::int64_t{surface.step}});
  mesh.set("cull_back_faces", {surface.cull_back_faces});
  Value value{json::Object{}};
  value.set("mesh", std::move(mesh));
  return value;
}

struct Canonical {
  Value operator()(const MapCamera& camera) const {
    Value map{json::Object{}};
    if (camera.size) map.set("size", list_of(*camera.size));
    return named("map", std::move(map));
  }
  Value operator()(const ViewCamera& camera) const {
    const bool perspective = camera.projection == ViewCamera::Projection::kPerspective;
    Value view{json::Object{}};
    view.set("eye", list_of(camera.eye));
    view.set("target", list_of(camera.target));
    view.set(perspective ? "fov" : "height", {camera.extent});
    view.set("size", list_of(camera.size));
    view.set("samples", {std::int64_t{camera.samples}});
    if (camera.mesh) view.set("surface", canonical_surface(*camera.mesh));
    return named(perspective ? kPerspective : kOrthographic, std::move(view));
  }
  Value operator()(const PointsCamera& camera) const {
    Value points{json::Object{}};
    points.set("file", {camera.below_root});
    return named("points", std::move(points));
  }

 private:
  static Value named(const char* name, Value value) {
    Value camera{json::Object{}};
    camera.set(name, std::move(value));
    return camera;
  }
};

}  // namespace

Camera read_camera(const Value* value, const BuildContext& context, Report& report) {
  if (!value) return MapCamera{};
  if (const Value* view = value->find(kPerspective))
    return read_view(*view, ViewCamera::Projection::kPerspective, report);
  if (const Value* view = value->find(kOrthographic))
    return read_view(*view, ViewCamera::Projection::kOrthographic, report);
  if (const Value* points = value->find("points")) return read_points(*points, context, report);
  const Value* map = value->find("map");
  return map ? read_map(*map) : MapCamera{};
}

Value canonical_camera(const Camera& camera) {
  return std::visit(Canonical{}, camera);
}

std::optional<std::array<int, 2>> image_size(const Camera& camera, std::array<int, 2> map_size) {
  if (const auto* view = std::get_if<ViewCamera>(&camera)) return view->size;
  if (const auto* map = std::get_if<MapCamera>(&camera)) return map->size.value_or(map_size);
  return std::nullopt;
}

}  // namespace gnomon::scene
