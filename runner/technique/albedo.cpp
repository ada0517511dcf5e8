// SPDX-License-Identifier: MIT
#include "technique/albedo.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "image/image.h"
#include "oracle/oracle.h"
#include "technique/surface.h"

namespace gnomon::technique {
namespace {

constexpr int kColoursByHeight = 1024;

float srgb_to_linear(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

glm::vec3 vector_of(const scene::Colour& colour) {
  return glm::vec3(colour[0], colour[1], colour[2]);
}

/// The colour at a height, linear between entries.
glm::vec3 colour_at(const std::vector<std::pair<double, scene::Colour>>& colours, double height) {
  const auto above =
      std::find_if(colours.begin(), colours.end(), [&](const auto& entry) { return entry.first >= height; });
  if (above == colours.begin()) return vector_of(above->second);
  if (above == colours.end()) return vector_of(colours.back().second);
  const auto& [low, from] = *std::prev(above);
  const auto& [high, to] = *above;
  return glm::mix(vector_of(from), vector_of(to), static_cast<float>((height - low) / (high - low)));
}

/// What a stored value of 1 means: integer files give 0..255 or 0..65535, encoded as sRGB; 0: linear already.
float full_scale(const std::array<const std::vector<float>*, 3>& planes) {
  float largest = 0;
  for (const auto* plane : planes)
    largest = std::max(largest, *std::max_element(plane->begin(), plane->end()));
  if (largest <= 1.0F) return 0.0F;
  return largest <= 255.0F ? 255.0F : 65535.0F;
}

struct Load {
  Result<Albedo> operator()(const scene::ConstantAlbedo& constant) const {
    return Albedo{.colours = {vector_of(constant.colour)}};
  }

  Result<Albedo> operator()(const scene::HeightAlbedo& by_height) const {
    Albedo albedo{.width = kColoursByHeight,
                  .colours = {},
                  .by_height = true,
                  .lowest = by_height.colours.front().first,
                  .highest = by_height.colours.back().first};
    const double step = (albedo.highest - albedo.lowest) / (kColoursByHeight - 1);
    for (int i = 0; i < kColoursByHeight; ++i)
      albedo.colours.push_back(colour_at(by_height.colours, albedo.lowest + i * step));
    return albedo;
  }

  Result<Albedo> operator()(const scene::ImageAlbedo& file) const {
    const Result<image::Image> image = image::read_image(file.path);
    if (!image) return image.diagnostics();
    const auto channel = [&](const char* name) {
      const std::vector<float>* own = image->channel(name);
      return own || image->channels.size() != 1 ? own : &image->channels.begin()->second;
    };
    const std::array planes{channel("R"), channel("G"), channel("B")};
    if (!planes[0] || !planes[1] || !planes[2] || image->pixels() == 0) {
      return Diagnostic{.file = file.path,
                        .message = "holds no colours; expected the channels R, G and B, or a single one"};
    }
    const float full = full_scale(planes);
    Albedo albedo{.width = image->width, .height = image->height, .colours = {}};
    for (std::size_t i = 0; i < image->pixels(); ++i) {
      const glm::vec3 stored((*planes[0])[i], (*planes[1])[i], (*planes[2])[i]);
      albedo.colours.push_back(full == 0.0F ? stored
                                            : glm::vec3(srgb_to_linear(stored.x / full),
                                                        srgb_to_linear(stored.y / full),
                                                        srgb_to_linear(stored.z / full)));
    }
    return albedo;
  }
};

/// At x, y texels from the west and north edge.
glm::vec3 look_up(const Albedo& albedo, double x, double y) {
  const auto [west, east_share] = [&] {
    const double at = std::clamp(x - 0.5, 0.0, albedo.width - 1.0);
    return std::pair{static_cast<int>(at), static_cast<float>(at - std::floor(at))};
  }();
  const auto [north, south_share] = [&] {
    const double at = std::clamp(y - 0.5, 0.0, albedo.height - 1.0);
    return std::pair{static_cast<int>(at), static_cast<float>(at - std::floor(at))};
  }();
  const auto at = [&](int column, int row) {
    const int inside_column = std::min(column, albedo.width - 1);
    const int inside_row = std::min(row, albedo.height - 1);
    return albedo.colours[static_cast<std::size_t>(inside_row) * static_cast<std::size_t>(albedo.width) +
                          static_cast<std::size_t>(inside_column)];
  };
  return glm::mix(glm::mix(at(west, north), at(west + 1, north), east_share),
                  glm::mix(at(west, north + 1), at(west + 1, north + 1), east_share), south_share);
}

}  // namespace

Result<Albedo> load_albedo(const scene::Ground& ground) {
  return std::visit(Load{}, ground.albedo);
}

std::vector<glm::vec3> albedo_under(const Ground& ground, const Albedo& albedo,
                                    const terrain::HeightMap& map) {
  const oracle::Surface surface = surface_of(map);
  std::vector<glm::vec3> colours(ground.pixels());
  for (std::size_t i = 0; i < ground.pixels(); ++i) {
    if (ground.valid[i] == 0) continue;
    const double column = ground.column[i];
    const double row = ground.row[i];
    if (albedo.by_height) {
      const double height = oracle::surface_height(surface, column, row);
      const double share = (height - albedo.lowest) / (albedo.highest - albedo.lowest);
      colours[i] = look_up(albedo, 0.5 + share * (albedo.width - 1), 0.5);
    } else {
      colours[i] = look_up(albedo, column / map.width * albedo.width, row / map.height * albedo.height);
    }
  }
  return colours;
}

}  // namespace gnomon::technique
