// SPDX-License-Identifier: MIT
#include "technique/ground.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "oracle/mesh_ray.h"
#include "oracle/view_ray.h"
#include "technique/camera.h"
#include "technique/map_host.h"
#include "technique/surface.h"
#include "terrain/holes.h"
#include "terrain/level.h"

namespace gnomon::technique {
namespace {

int coarsest_of(const terrain::HeightMap& map) {
  return terrain::coarsest_level(map.width, map.height);
}

/// Algo 1 for a pixel whose point moves by these texels from pixel to pixel.
int level_of_detail(const MapHost& host, glm::vec2 along_x, glm::vec2 along_y, const scene::Shadow& shadow,
                    int coarsest) {
  return host.gnomon_level_of_detail(along_x, along_y, static_cast<float>(shadow.max_anisotropy), coarsest);
}

/// Where rays meet what the camera shows of the surface.
std::function<std::optional<double>(const oracle::ViewRay&)> tracer_of(const oracle::Surface& surface,
                                                                       const scene::ViewCamera& camera) {
  if (camera.mesh) {
    return [tracer = oracle::MeshTracer(surface, camera.mesh->step, camera.mesh->cull_back_faces)](
               const oracle::ViewRay& ray) { return tracer.first_hit(ray); };
  }
  return [tracer = oracle::ViewTracer(surface)](const oracle::ViewRay& ray) { return tracer.first_hit(ray); };
}

/// The first pixel that cannot be asked, and why.
std::optional<std::string> wrong_point(const Ground& ground, const terrain::HeightMap& map) {
  const int coarsest = coarsest_of(map);
  for (std::size_t i = 0; i < ground.pixels(); ++i) {
    if (ground.valid[i] == 0) continue;
    const auto width = static_cast<std::size_t>(ground.size.x);
    const std::string pixel = "pixel (" + std::to_string(i % width) + ", " + std::to_string(i / width) + ")";
    const bool inside = ground.column[i] >= 0 && ground.column[i] <= static_cast<float>(map.width) &&
                        ground.row[i] >= 0 && ground.row[i] <= static_cast<float>(map.height);
    if (!inside) {
      return pixel + " asks for column " + std::to_string(ground.column[i]) + ", row " +
             std::to_string(ground.row[i]) + ", which lies outside of the " + std::to_string(map.width) +
             "x" + std::to_string(map.height) + " map";
    }
    const float q = ground.q[i];
    if (!(q >= 0 && q <= static_cast<float>(coarsest)) || q != std::floor(q)) {
      return pixel + " asks for level " + std::to_string(q) + "; this map has the levels 0 to " +
             std::to_string(coarsest);
    }
  }
  return std::nullopt;
}

}  // namespace

std::set<int> Ground::levels() const {
  std::set<int> levels;
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (valid[i] != 0) levels.insert(static_cast<int>(q[i]));
  }
  return levels;
}

std::vector<std::size_t> Ground::asking(int level) const {
  std::vector<std::size_t> asking;
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (valid[i] != 0 && static_cast<int>(q[i]) == level) asking.push_back(i);
  }
  return asking;
}

void leave_out_holes(Ground& ground, const terrain::HeightMap& map) {
  if (!map.holes) return;
  for (const int q : ground.levels()) {
    const terrain::HeightMap level = terrain::level(map, q);
    for (const std::size_t i : ground.asking(q)) {
      const double column = double{ground.column[i]};
      const double row = double{ground.row[i]};
      const bool surface = terrain::has_surface(map, column, row) &&
                           terrain::has_surface(level, std::ldexp(column, -q), std::ldexp(row, -q));
      ground.valid[i] = surface ? 1.0F : 0.0F;
    }
  }
}

Ground empty_ground(glm::ivec2 size, const scene::Shadow& shadow) {
  Ground ground{.size = size};
  const auto pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  ground.column.resize(pixels);
  ground.row.resize(pixels);
  ground.valid.resize(pixels);
  ground.q.assign(pixels, static_cast<float>(shadow.q.value_or(0)));
  return ground;
}

image::Image lit_image(const Ground& ground) {
  image::Image image{.width = ground.size.x, .height = ground.size.y, .channels = {}, .attributes = {}};
  for (const char* name : {"b_shadow", "steps"}) image.channels[name].resize(image.pixels());
  image.channels["k_shadow"].assign(image.pixels(), 1.0F);
  image.channels["q"] = ground.q;
  image.channels["valid"] = ground.valid;
  if (ground.depth.empty()) return image;
  image.channels["column"] = ground.column;
  image.channels["row"] = ground.row;
  image.channels["depth"] = ground.depth;
  return image;
}

Ground map_ground(const scene::MapCamera& camera, const scene::Shadow& shadow,
                  const terrain::HeightMap& map) {
  const glm::ivec2 size =
      camera.size ? glm::ivec2((*camera.size)[0], (*camera.size)[1]) : glm::ivec2(map.width, map.height);
  Ground ground = empty_ground(size, shadow);
  ground.texels_per_pixel = glm::vec2(glm::dvec2(map.width, map.height) / glm::dvec2(size));
  ground.valid.assign(ground.pixels(), 1.0F);
  if (!shadow.q) {
    const glm::vec2 step = ground.texels_per_pixel;
    const int level = level_of_detail(MapHost(map), {step.x, 0}, {0, step.y}, shadow, coarsest_of(map));
    ground.q.assign(ground.pixels(), static_cast<float>(level));
  }
  std::size_t i = 0;
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x, ++i) {
      // The very product that programs/shadow_pass.glsl forms.
      ground.column[i] = (static_cast<float>(x) + 0.5F) * ground.texels_per_pixel.x;
      ground.row[i] = (static_cast<float>(y) + 0.5F) * ground.texels_per_pixel.y;
    }
  }
  return ground;
}

Result<Ground> points_ground(const image::Image& image, const std::string& file, const scene::Shadow& shadow,
                             const terrain::HeightMap& map) {
  for (const char* needed : {"column", "row", "q"}) {
    const bool is_needed = std::string_view(needed) != "q" || !shadow.q;
    if (is_needed && !image.channel(needed)) {
      return Diagnostic{
          .file = file,
          .message = std::string("has no channel '") + needed +
                     "'; expected an EXR that gnomon rendered with a perspective or orthographic "
                     "camera"};
    }
  }
  Ground ground = empty_ground({image.width, image.height}, shadow);
  ground.column = *image.channel("column");
  ground.row = *image.channel("row");
  ground.valid.assign(ground.pixels(), 1.0F);
  if (const std::vector<float>* valid = image.channel("valid")) ground.valid = *valid;
  if (!shadow.q) ground.q = *image.channel("q");
  const std::vector<float>* depth = image.channel("depth");
  ground.depth = depth ? *depth : std::vector<float>(ground.pixels());
  if (const auto wrong = wrong_point(ground, map)) return Diagnostic{.file = file, .message = *wrong};
  return ground;
}

namespace {

/// What the pixels of a window of the image see; `first`: the window's upper left pixel.
Ground reference_window(const terrain::HeightMap& map, const scene::ViewCamera& camera,
                        const scene::Shadow& shadow, glm::ivec2 size, glm::dvec2 first) {
  const CameraRays rays = camera_rays(camera);
  const oracle::Surface surface = surface_of(map);
  const auto first_hit = tracer_of(surface, camera);
  const MapHost host(map);
  const Modules::GnomonMap taken = host.map();
  const int coarsest = coarsest_of(map);
  Ground ground = empty_ground(size, shadow);
  ground.depth.resize(ground.pixels());
  std::size_t i = 0;
  for (int y = 0; y < ground.size.y; ++y) {
    for (int x = 0; x < ground.size.x; ++x, ++i) {
      const auto [origin, direction] = rays.ray(glm::dvec2(x + 0.5, y + 0.5) + first);
      const auto hit = first_hit({{origin.x, origin.y, origin.z}, {direction.x, direction.y, direction.z}});
      if (!hit) continue;
      const glm::dvec3 at = origin + *hit * direction;
      ground.valid[i] = 1;
      ground.depth[i] = static_cast<float>(*hit * glm::length(direction));
      ground.column[i] = static_cast<float>(std::clamp(at.x / map.spacing_x, 0.0, map.domain_width));
      ground.row[i] =
          static_cast<float>(std::clamp(map.domain_height - at.y / map.spacing_y, 0.0, map.domain_height));
      if (shadow.q) continue;
      const glm::vec3 normal =
          host.gnomon_surface_normal(taken, host.gnomon_receiver_at(ground.column[i], ground.row[i], 0), 0);
      const auto footprint = [&](glm::dvec3 pixel) {
        const glm::vec3 moved(rays.perspective ? pixel * *hit : pixel);
        return host.gnomon_footprint(taken, normal, glm::vec3(direction), moved);
      };
      ground.q[i] = static_cast<float>(
          level_of_detail(host, footprint(rays.right), footprint(rays.down), shadow, coarsest));
    }
  }
  return ground;
}

}  // namespace

Ground reference_ground(const terrain::HeightMap& map, const scene::ViewCamera& camera,
                        const scene::Shadow& shadow, glm::dvec2 offset) {
  return reference_window(map, camera, shadow, {camera.size[0], camera.size[1]}, offset);
}

Ground reference_pixel(const terrain::HeightMap& map, const scene::ViewCamera& camera,
                       const scene::Shadow& shadow, glm::ivec2 pixel) {
  return reference_window(map, camera, shadow, {1, 1}, glm::dvec2(pixel));
}

}  // namespace gnomon::technique
