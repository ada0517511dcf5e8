// SPDX-License-Identifier: MIT
#include "technique/lit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "technique/map_host.h"
#include "technique/sun.h"
#include "technique/tiles.h"

namespace gnomon::technique {
namespace {

constexpr std::array<float, 3> kSky{0.42F, 0.58F, 0.78F};  // linear

unsigned char to_srgb8(float linear) {
  const float clamped = std::clamp(linear, 0.0F, 1.0F);
  const float encoded =
      clamped <= 0.0031308F ? clamped * 12.92F : 1.055F * std::pow(clamped, 1 / 2.4F) - 0.055F;
  return static_cast<unsigned char>(std::lround(encoded * 255.0F));
}

using Planes = std::array<std::vector<float>*, 3>;

Planes colour_planes(image::Image& image) {
  const Planes planes{&image.channels["R"], &image.channels["G"], &image.channels["B"]};
  for (std::vector<float>* plane : planes) plane->assign(image.pixels(), 0.0F);
  return planes;
}

Result<gl::Texture> upload_albedo(const Ground& ground, const Tile& tile,
                                  const std::vector<glm::vec3>& albedo) {
  std::vector<float> texels;
  for (int y = 0; y < tile.size.y; ++y) {
    for (int x = 0; x < tile.size.x; ++x) {
      const glm::vec3& colour = albedo[ground.index(tile.first + glm::ivec2(x, y))];
      texels.insert(texels.end(), {colour.x, colour.y, colour.z, 1.0F});
    }
  }
  Result<gl::Texture> texture = gl::Texture::create(gl::Format::kRgba32F, {tile.size.x, tile.size.y});
  if (texture) texture->upload(texels);
  return texture;
}

Result<Done> light_tile(const gl::Program& program, const Pyramid& base, const Uniforms& uniforms,
                        const Tile& tile, const Ground& ground, const std::vector<glm::vec3>& albedo,
                        const std::vector<float>& k_shadow, const Planes& planes) {
  const Result<gl::Texture> points = upload_points(ground, tile, k_shadow);
  if (!points) return points.diagnostics();
  const Result<gl::Texture> colours = upload_albedo(ground, tile, albedo);
  if (!colours) return colours.diagnostics();
  std::vector<gl::Sampler> samplers = map_samplers(base);
  samplers.push_back({.name = "u_ground", .texture = &points.value()});
  samplers.push_back({.name = "u_albedo", .texture = &colours.value()});
  const Result<Texels> texels =
      draw_tile(tile, {.program = &program, .uniforms = uniforms, .samplers = std::move(samplers)}, nullptr);
  if (!texels) return texels.diagnostics();
  for (int y = 0; y < tile.size.y; ++y) {
    for (int x = 0; x < tile.size.x; ++x) {
      const std::size_t i = ground.index(tile.first + glm::ivec2(x, y));
      for (std::size_t c = 0; c < planes.size(); ++c) (*planes[c])[i] = texels->at(x, y)[c];
    }
  }
  return Done{};
}

}  // namespace

Result<Done> light(ProgramCache& programs, const Pyramid& base, const scene::Scene& scene,
                   const Ground& ground, const std::vector<glm::vec3>& albedo, image::Image& image) {
  const Result<const CachedProgram*> program = programs.get("programs/lit.frag");
  if (!program) return program.diagnostics();
  Uniforms uniforms = map_uniforms(base);
  uniforms.emplace_back("u_to_sun", to_sun_single(scene.sun));
  uniforms.emplace_back("u_ambient", static_cast<float>(scene.ground.ambient));
  const Planes planes = colour_planes(image);
  for (const Tile& tile : tiles_of(ground.size)) {
    const Result<Done> lit = light_tile((*program)->program, base, uniforms, tile, ground, albedo,
                                        image.channels.at("k_shadow"), planes);
    if (!lit) return lit;
  }
  return Done{};
}

void light_reference(const terrain::HeightMap& map, const scene::Scene& scene, const Ground& ground,
                     const std::vector<glm::vec3>& albedo, image::Image& image) {
  const MapHost host(map);
  const std::vector<float>& k_shadow = image.channels.at("k_shadow");
  const Planes planes = colour_planes(image);
  for (std::size_t i = 0; i < ground.pixels(); ++i) {
    if (ground.valid[i] == 0) continue;
    const auto receiver = host.gnomon_receiver_at(ground.column[i], ground.row[i], 0);
    const glm::vec3 colour =
        host.gnomon_lit(albedo[i], host.gnomon_surface_normal(host.map(), receiver, 0),
                        to_sun_single(scene.sun), k_shadow[i], static_cast<float>(scene.ground.ambient));
    for (glm::length_t c = 0; c < 3; ++c) (*planes[static_cast<std::size_t>(c)])[i] = colour[c];
  }
}

image::Picture lit_picture(const image::Image& image) {
  image::Picture picture{.width = image.width, .height = image.height, .rgb = {}};
  const std::array planes{&image.channels.at("R"), &image.channels.at("G"), &image.channels.at("B")};
  const std::vector<float>* coverage = image.channel("coverage");
  const std::vector<float>& seen = coverage ? *coverage : image.channels.at("valid");
  for (std::size_t i = 0; i < image.pixels(); ++i) {
    for (std::size_t c = 0; c < planes.size(); ++c)
      picture.rgb.push_back(to_srgb8((*planes[c])[i] + (1.0F - seen[i]) * kSky[c]));
  }
  return picture;
}

}  // namespace gnomon::technique
