// SPDX-License-Identifier: MIT
#include "technique/cascades.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "technique/casters.h"
#include "technique/mesh.h"
#include "technique/sun.h"

namespace gnomon::technique {
namespace {

using glm::dvec2;
using glm::dvec3;

/// The sun's view: as an orthographic camera's rays, a pixel of 1 metre.
CameraRays light_rays(dvec3 to_sun, dvec3 eye) {
  // Its axes are those of a camera at the origin, whose target is exact; the eye may be far away.
  CameraRays rays = camera_rays({.projection = scene::ViewCamera::Projection::kOrthographic,
                                 .target = {-to_sun.x, -to_sun.y, -to_sun.z},
                                 .extent = 1,
                                 .size = {1, 1}});
  rays.eye = eye;
  return rays;
}

/// How far along a camera's `forward` the points of a render lie: nearest and farthest, in metres; absent
/// where it sees none.
std::optional<dvec2> seen_depths(const CameraRays& rays, const Ground& ground) {
  dvec2 depths(std::numeric_limits<double>::max(), 0);
  for (std::size_t i = 0; i < ground.pixels(); ++i) {
    if (ground.valid[i] == 0) continue;
    const auto x = static_cast<double>(i % static_cast<std::size_t>(ground.size.x));
    const auto y = static_cast<double>(i / static_cast<std::size_t>(ground.size.x));
    const double depth = double{ground.depth[i]} / glm::length(rays.ray(dvec2(x, y) + 0.5).direction);
    depths = {std::min(depths.x, depth), std::max(depths.y, depth)};
  }
  if (depths.x > depths.y) return std::nullopt;
  return depths;
}

/// Where slice 0..count ends: the mean of equal ratios and equal depths, Zhang et al. 2006, eq. 6.
double split_depth(dvec2 depths, int slice, const scene::Cascades& cascades) {
  const double share = double(slice) / cascades.count;
  const double uniform = depths.x + (depths.y - depths.x) * share;
  const double nearest = std::max(depths.x, 1e-6 * depths.y);
  const double logarithmic = nearest * std::pow(depths.y / nearest, share);
  return cascades.split * logarithmic + (1 - cascades.split) * uniform;
}

/// The part of a camera's view between two depths.
Corners slice_of(const CameraRays& rays, double from, double to) {
  Corners corners;
  for (const double depth : {from, to}) {
    for (const dvec2 pixel :
         {dvec2(0), dvec2(2 * rays.middle.x, 0), dvec2(0, 2 * rays.middle.y), 2.0 * rays.middle}) {
      const ViewRay ray = rays.ray(pixel);
      corners.push_back(ray.origin + depth * ray.direction);
    }
  }
  return corners;
}

struct Box2 {
  dvec2 low{std::numeric_limits<double>::max()};
  dvec2 high{std::numeric_limits<double>::lowest()};
  [[nodiscard]] double side() const { return std::max(high.x - low.x, high.y - low.y); }
};

/// `room`: metres on each side, for receivers above the ground.
Box2 seen_by(const CameraRays& light, const Corners& corners, double room) {
  Box2 box;
  for (const dvec3& corner : corners) {
    const dvec3 to = corner - light.eye;
    const dvec2 at(glm::dot(to, light.right), glm::dot(to, light.down));
    box = {glm::min(box.low, at), glm::max(box.high, at)};
  }
  return {box.low - room, box.high + room};
}

/// A square whose side does not change when the slice turns.
Box2 around(const CameraRays& light, const Corners& corners, double room) {
  dvec3 centre(0);
  for (const dvec3& corner : corners) centre += corner / double(corners.size());
  double radius = room;
  for (const dvec3& corner : corners) radius = std::max(radius, glm::distance(centre, corner) + room);
  // A camera that moves sees a little farther or nearer: the side changes by steps of a fifth, seldom.
  const double steady = std::exp2(std::ceil(4 * std::log2(std::max(radius, 1e-6))) / 4);
  const dvec3 to = centre - light.eye;
  const dvec2 at(glm::dot(to, light.right), glm::dot(to, light.down));
  return {at - steady, at + steady};
}

/// Texels that a cascade keeps free on each side for the filter and for snapping.
double margin(const scene::Cascades& cascades) {
  return 0.5 * cascades.filter + 1;
}

CascadeSquare square_of(const Box2& box, const scene::Cascades& cascades) {
  const double free = margin(cascades);
  const double texel = std::max(box.side(), 1e-6) / (cascades.size - 2 * free);
  dvec2 corner = 0.5 * (box.low + box.high) - 0.5 * cascades.size * texel;
  if (cascades.stable) corner = glm::floor(corner / texel) * texel;
  return {corner, texel};
}

/// The slice's square, or the whole map's part that it may hold, where that is smaller.
Box2 slice_box(const CameraRays& light, const Corners& slice, const Box2& map, const scene::Shadow& shadow) {
  const Box2 tight = seen_by(light, slice, shadow.receiver_height);
  const Box2 held{glm::max(tight.low, map.low), glm::min(tight.high, map.high)};
  if (!shadow.cascades.stable) return held.low.x < held.high.x && held.low.y < held.high.y ? held : tight;
  const Box2 steady = around(light, slice, shadow.receiver_height);
  return steady.side() < map.side() ? steady : map;
}

}  // namespace

CascadeFit fit_cascades(const scene::Scene& scene, const Ground& ground, const Pyramid& pyramid) {
  const dvec3 sun = to_sun(scene.sun);
  const dvec2 extent = extent_along(pyramid, dvec3(0), -sun);
  const double room = 1e-3 * (extent.y - extent.x) + 1e-3;
  const CameraRays light = light_rays(sun, -sun * (extent.x - room));
  CascadeFit fit{.origin = light.eye,
                 .right = light.right,
                 .down = light.down,
                 .forward = light.forward,
                 .range = extent.y - extent.x + 2 * room};
  const Box2 map = seen_by(light, box_of(pyramid), scene.shadow.receiver_height);
  const auto* camera = std::get_if<scene::ViewCamera>(&scene.camera);
  const scene::Cascades& cascades = scene.shadow.cascades;
  std::optional<dvec2> depths;
  CameraRays rays;
  if (camera) {
    rays = camera_rays(*camera);
    depths = seen_depths(rays, ground);
  }
  if (!depths) {
    fit.squares = {square_of(map, cascades)};
    return fit;
  }
  depths->y = std::min(depths->y, std::max(cascades.distance.value_or(depths->y), depths->x));
  for (int i = 0; i < cascades.count; ++i) {
    const Corners slice =
        slice_of(rays, split_depth(*depths, i, cascades), split_depth(*depths, i + 1, cascades));
    fit.squares.push_back(square_of(slice_box(light, slice, map, scene.shadow), cascades));
  }
  std::stable_sort(fit.squares.begin(), fit.squares.end(),
                   [](const CascadeSquare& a, const CascadeSquare& b) { return a.texel < b.texel; });
  return fit;
}

namespace {

gl::Faces faces_of(scene::Cascades::Faces faces) {
  if (faces == scene::Cascades::Faces::kFront) return gl::Faces::kFront;
  return faces == scene::Cascades::Faces::kBack ? gl::Faces::kBack : gl::Faces::kAll;
}

Uniforms light_uniforms(const CascadeFit& fit, const scene::Cascades& cascades) {
  Uniforms uniforms{{"u_light_origin", glm::vec3(fit.origin)},
                    {"u_light_right", glm::vec3(fit.right)},
                    {"u_light_down", glm::vec3(fit.down)},
                    {"u_light_range", static_cast<float>(fit.range)},
                    {"u_light_size", cascades.size},
                    {"u_light_cascades", static_cast<int>(fit.squares.size())},
                    {"u_light_grid_step", cascades.step},
                    {"u_light_bias", glm::vec2(cascades.bias, cascades.slope_bias)},
                    {"u_light_filter", cascades.filter}};
  for (std::size_t i = 0; i < fit.squares.size(); ++i) {
    uniforms.emplace_back("u_cascades[" + std::to_string(i) + "]",
                          glm::vec3(fit.squares[i].corner, fit.squares[i].texel));
  }
  return uniforms;
}

/// The sun as a camera whose image is one square.
CameraRays square_rays(const CascadeFit& fit, const CascadeSquare& square) {
  return {.perspective = false,
          .eye = fit.origin,
          .forward = fit.forward,
          .right = fit.right * square.texel,
          .down = fit.down * square.texel,
          .middle = -square.corner / square.texel};
}

gl::Pass square_pass(const gl::Program& program, const Pyramid& pyramid, const CascadeFit& fit,
                     std::size_t cascade, const scene::Cascades& cascades, const gl::Texture& nearness) {
  const CameraRays rays = square_rays(fit, fit.squares[cascade]);
  Uniforms uniforms = map_uniforms(pyramid);
  for (auto& uniform : camera_uniforms(rays)) uniforms.push_back(std::move(uniform));
  uniforms.emplace_back("u_grid_step", cascades.step);
  uniforms.emplace_back("u_far", static_cast<float>(fit.range));
  uniforms.emplace_back("u_first_pixel", glm::vec2(0));
  uniforms.emplace_back("u_tile_size", glm::vec2(static_cast<float>(cascades.size)));
  gl::Mesh mesh{.parts = casters(pyramid, cascades, fit, fit.squares[cascade]),
                .faces = faces_of(cascades.faces),
                .depth = &nearness};
  return {
      .program = &program,
      .uniforms = std::move(uniforms),
      .samplers = map_samplers(pyramid),
      .window = gl::Window{glm::ivec2(cascade & 1, cascade >> 1) * cascades.size, glm::ivec2(cascades.size)},
      .mesh = mesh};
}

}  // namespace

Result<const CachedProgram*> depth_program(ProgramCache& programs, bool holes) {
  return programs.get(holes ? "programs/light_holes.frag" : "programs/light.frag", "programs/mesh.vert");
}

Result<CascadeMaps> draw_cascades(ProgramCache& programs, const Pyramid& pyramid, const scene::Scene& scene,
                                  const Ground& ground, double& seconds) {
  const Result<const CachedProgram*> program = depth_program(programs, pyramid.holes);
  if (!program) return program.diagnostics();
  const scene::Cascades& cascades = scene.shadow.cascades;
  const CascadeFit fit = fit_cascades(scene, ground, pyramid);
  const int columns = fit.squares.size() > 1 ? 2 : 1;
  const int rows = fit.squares.size() > 2 ? 2 : 1;
  Result<gl::Texture> nearness =
      gl::Texture::create(gl::Format::kDepth32F, {columns * cascades.size, rows * cascades.size});
  if (!nearness) {
    return Diagnostic{.message = "shadow.cascades.size " + std::to_string(cascades.size) + ": " +
                                 nearness.diagnostics().front().message,
                      .failure = nearness.diagnostics().front().failure};
  }
  std::vector<gl::Pass> passes;
  for (std::size_t i = 0; i < fit.squares.size(); ++i)
    passes.push_back(square_pass((*program)->program, pyramid, fit, i, cascades, *nearness));
  if (const Result<Done> drawn = draw_timed(passes, &seconds); !drawn) return drawn.diagnostics();
  return CascadeMaps{std::move(nearness).value(), light_uniforms(fit, cascades)};
}

}  // namespace gnomon::technique
