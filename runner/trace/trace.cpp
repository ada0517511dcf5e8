// SPDX-License-Identifier: MIT
#include "trace/trace.h"

#include <algorithm>
#include <cmath>

#include "technique/reference.h"
#include "technique/sun.h"
#include "trace/point.h"
#include "trace/walk.h"

namespace gnomon::trace {
namespace {

/// The receiver as programs/shadow_pass.glsl forms it.
Modules::GnomonReceiver receiver_of(const PixelModules& modules, const Point& point,
                                    const scene::Shadow& shadow) {
  const auto scale = static_cast<float>(std::ldexp(1.0, -modules.q()));
  return modules.gnomon_receiver_at(point.ground.column[0] * scale, point.ground.row[0] * scale,
                                    static_cast<float>(shadow.receiver_height));
}

Result<Walk> walk_of(const scene::Scene& scene, const terrain::HeightMap& base, const Point& point) {
  const PixelModules modules(base, static_cast<int>(point.ground.q[0]));
  const Question question{receiver_of(modules, point, scene.shadow), technique::to_sun_single(scene.sun)};
  if (scene.shadow.method == "multilevel_literal") return observe_literal_walk(modules, question);
  return observe_walk(modules, question, scene.shadow.method);
}

OracleAnswer oracle_of(const scene::Scene& scene, const terrain::HeightMap& base, const Point& point) {
  const image::Image image = technique::reference_image(scene, base, point.ground);
  return {.horizon = image.channels.at("horizon")[0],
          .shadow = image.channels.at("b_shadow")[0] != 0,
          .in_band = image.channels.at("band")[0] != 0};
}

std::string method_list() {
  std::string names;
  for (const std::string& name : traceable_methods()) names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

const std::vector<std::string>& traceable_methods() {
  static const std::vector<std::string> names{"multilevel", "multilevel_literal", "brute_force"};
  return names;
}

std::string name_of(Decision decision) {
  switch (decision) {
    case Decision::kSkips:
      return "skips";
    case Decision::kDescends:
      return "descends";
    case Decision::kPasses:
      return "passes";
    case Decision::kHole:
      return "hole";
    case Decision::kTouches:
      return "touches";
    case Decision::kHides:
      return "hides";
    case Decision::kLowest:
      return "lowest_hides";
  }
  return {};
}

std::string cause_name(int cause) {
  switch (cause) {
    case GNOMON_CAUSE_SURFACE:
      return "surface";
    case GNOMON_CAUSE_SUN_BELOW:
      return "sun_below";
    case GNOMON_CAUSE_ZENITH:
      return "zenith";
    case GNOMON_CAUSE_LEFT_MAP:
      return "left_map";
    case GNOMON_CAUSE_ABOVE_ALL:
      return "above_all";
    case GNOMON_CAUSE_BELOW_BLOCK:
      return "below_block";
    default:
      return "undecided";
  }
}

std::string cause_text(int cause) {
  switch (cause) {
    case GNOMON_CAUSE_SURFACE:
      return "the surface rises above the ray";
    case GNOMON_CAUSE_SUN_BELOW:
      return "no ray is cast, as the sun does not stand above the horizontal plane";
    case GNOMON_CAUSE_ZENITH:
      return "no ray is cast, as the sun stands at the zenith";
    case GNOMON_CAUSE_LEFT_MAP:
      return "the ray left the map";
    case GNOMON_CAUSE_ABOVE_ALL:
      return "the ray rose above the highest sample";
    case GNOMON_CAUSE_BELOW_BLOCK:
      return "already the lowest height of a block rises to the ray";
    default:
      return "undecided: the ray reached its bound of steps, which is a fault of the method";
  }
}

Result<Trace> trace_pixel(const scene::Scene& scene, const terrain::HeightMap& base, glm::ivec2 pixel) {
  const auto& methods = traceable_methods();
  if (std::find(methods.begin(), methods.end(), scene.shadow.method) == methods.end()) {
    return Diagnostic{
        .file = scene.file,
        .message = "the method '" + scene.shadow.method +
                   "' has no steps that could be told; name one that has with --method: " + method_list()};
  }
  Result<Point> point = point_of(scene, base, pixel);
  if (!point) return point.diagnostics();
  Trace trace{.pixel = pixel, .point = std::move(point).value()};
  if (!trace.point.valid()) return trace;
  Result<Walk> walk = walk_of(scene, base, trace.point);
  if (!walk) return walk.diagnostics();
  trace.walk = std::move(walk).value();
  trace.oracle = oracle_of(scene, base, trace.point);
  return trace;
}

}  // namespace gnomon::trace
