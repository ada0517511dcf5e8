// SPDX-License-Identifier: MIT
#include "engine.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "image/hillshade.h"
#include "oracle/oracle.h"
#include "sample_mean.h"
#include "scene/load.h"
#include "technique/hash.h"
#include "technique/lit.h"
#include "technique/reference.h"
#include "technique/renderer.h"
#include "technique/surface.h"
#include "technique/technique.h"
#include "terrain/load.h"
#include "terrain/procedural.h"

namespace gnomon {
namespace {

using scene::Scene;
using terrain::HeightMap;
using terrain::LoadedHeightMap;

/// Wider than any map of a planet, narrower than what single precision holds.
constexpr double kSmallestSpacing = 1e-6;  // metres
constexpr double kLargestSpacing = 1e9;

Diagnostics check_spacing(const HeightMap& map, const Scene& scene) {
  const auto [smaller, larger] = std::minmax(map.spacing_x, map.spacing_y);
  if (smaller >= kSmallestSpacing && larger <= kLargestSpacing) return {};
  return {{.file = scene.file, .message = "the spacing of the height map has to be 1e-6 to 1e9 metres"}};
}

std::array<double, 2> spacing_of(const scene::Terrain& terrain) {
  return terrain.spacing.value_or(std::array{1.0, 1.0});
}

double scale_of(const scene::Terrain& terrain) {
  return terrain.vertical_scale.value_or(1.0);
}

struct MakeTerrain {
  const scene::Terrain& terrain;

  Result<LoadedHeightMap> operator()(const scene::FileTerrain& file) const {
    return terrain::load_height_map(file.path, {.spacing = terrain.spacing,
                                                .vertical_scale = terrain.vertical_scale,
                                                .channel = file.channel,
                                                .raw = file.raw,
                                                .nodata = file.nodata});
  }

  Result<LoadedHeightMap> operator()(const scene::InlineTerrain& table) const {
    const auto [x, y] = spacing_of(terrain);
    HeightMap map{.width = table.width,
                  .height = table.height,
                  .spacing_x = x,
                  .spacing_y = y,
                  .domain_width = double(table.width),
                  .domain_height = double(table.height)};
    std::transform(
        table.heights.begin(), table.heights.end(), std::back_inserter(map.samples), [&](double stored) {
          return stored == scene::InlineTerrain::kNull ? terrain::kNoSample
                                                       : static_cast<float>(stored * scale_of(terrain));
        });
    map.holes = std::count(table.heights.begin(), table.heights.end(), scene::InlineTerrain::kNull) > 0;
    return LoadedHeightMap{std::move(map), {}};
  }

  Result<LoadedHeightMap> operator()(const scene::ProceduralTerrain& made) const {
    const auto [x, y] = spacing_of(terrain);
    Result<HeightMap> map = terrain::make_procedural({.kind = made.kind,
                                                      .width = made.width,
                                                      .height = made.height,
                                                      .seed = made.seed,
                                                      .spacing_x = x,
                                                      .spacing_y = y,
                                                      .vertical_scale = scale_of(terrain),
                                                      .parameters = made.parameters});
    if (!map) return map.diagnostics();
    return LoadedHeightMap{std::move(map).value(), {}};
  }
};

/// A failure that names no file is the scene's.
Diagnostics in_scene(Diagnostics diagnostics, const Scene& scene) {
  for (Diagnostic& diagnostic : diagnostics) {
    if (diagnostic.file.empty() && diagnostic.failure != Failure::kMachine) diagnostic.file = scene.file;
  }
  return diagnostics;
}

/// Whether the user asked for a back end or a device by name.
bool is_named(const EngineOptions& options) {
  return options.backend == Backend::kEgl || options.backend == Backend::kOsmesa || !options.device.empty();
}

gl::Request request_of(const EngineOptions& options) {
  gl::Request request{.device = options.device};
  if (options.backend == Backend::kEgl) request.api = gl::Api::kEgl;
  if (options.backend == Backend::kOsmesa) request.api = gl::Api::kOsmesa;
  return request;
}

/// A lit image with the shadows of another image of the same points: k_shadow is a factor of R, G and B.
image::Image relit(const image::Image& lit, const image::Image& shadows) {
  image::Image image = lit;
  const std::vector<float>&had = lit.channels.at("k_shadow"), &has = shadows.channels.at("k_shadow");
  for (const char* name : {"R", "G", "B"}) {
    std::vector<float>& plane = image.channels.at(name);
    for (std::size_t i = 0; i < plane.size() && i < has.size(); ++i)
      plane[i] = had[i] > 0 ? plane[i] * has[i] / had[i] : 0.0F;
  }
  return image;
}

/// Ground of one colour, its shadows alone: points need not lie side by side, so their slopes are not known.
image::Image evenly_lit(const image::Image& shadows) {
  constexpr float kGrey = 0.5F;
  image::Image image = shadows;
  std::vector<float> grey = shadows.channels.at("k_shadow");
  const std::vector<float>& valid = shadows.channels.at("valid");
  for (std::size_t i = 0; i < grey.size(); ++i) grey[i] *= valid[i] != 0 ? kGrey : 0.0F;
  for (const char* name : {"R", "G", "B"}) image.channels[name] = grey;
  return image;
}

/// The heights under the pixels of a view, for pictures.
std::vector<float> heights_under(const HeightMap& map, const technique::Ground& ground) {
  if (ground.on_samples()) return map.samples;
  const oracle::Surface surface = technique::surface_of(map);
  std::vector<float> heights;
  for (std::size_t i = 0; i < ground.pixels(); ++i) {
    heights.push_back(
        static_cast<float>(oracle::surface_height(surface, double{ground.column[i]}, double{ground.row[i]})));
  }
  return heights;
}

}  // namespace

Result<std::shared_ptr<const HeightMap>> Engine::terrain(const Scene& scene) {
  if (terrain_ && terrain_->source == scene.terrain) return terrain_->map;
  Result<LoadedHeightMap> loaded = std::visit(MakeTerrain{scene.terrain}, scene.terrain.source);
  if (!loaded) return in_scene(loaded.diagnostics(), scene);
  if (Diagnostics wrong = check_spacing(loaded->map, scene); !wrong.empty()) return wrong;
  terrain_ = LoadedTerrain{scene.terrain, std::make_shared<const HeightMap>(std::move(loaded->map)),
                           std::move(loaded->notes), std::move(loaded->georeference)};
  return terrain_->map;
}

Engine::~Engine() {
  // Textures and programs have to go where they came from, also while another engine's context is current.
  if (context_) static_cast<void>(context_->make_current());
}

Result<const gl::Info*> Engine::gl_info() {
  if (options_.backend == Backend::kCpu) {
    return Diagnostic{.message = "'--backend cpu' renders without OpenGL: use it with --method reference"};
  }
  if (!context_) {
    Result<gl::Context> context = gl::Context::create(request_of(options_));
    if (!context) return context.diagnostics();
    context_ = std::move(context).value();
    programs_.emplace(compiler::Options{.library_directory = options_.shader_library,
                                        .include_directories = options_.includes,
                                        .target = options_.target});
  }
  if (const Result<Done> current = context_->make_current(); !current) return current.diagnostics();
  return &context_->info();
}

Result<const technique::Pyramid*> Engine::pyramid(const Map& map, int q, technique::Bounds bounds) {
  if (pyramids_.map != map) pyramids_ = {map, {}};  // first: those of two large maps need not fit
  auto found = pyramids_.levels.find(q);
  if (found == pyramids_.levels.end()) {
    Result<technique::Pyramid> built = technique::build_pyramid(*programs_, *map, q);
    if (!built) return built.diagnostics();
    found = pyramids_.levels.emplace(q, std::move(built).value()).first;
  }
  technique::Pyramid& pyramid = found->second;
  if (bounds == technique::Bounds::kLiteralExtrema && !pyramid.literal_extrema) {
    auto literal = technique::build_literal_extrema(*programs_, *map);
    if (!literal) return literal.diagnostics();
    pyramid.literal_extrema = std::move(literal).value();
  }
  if (bounds == technique::Bounds::kCascades && !pyramid.height_ranges)
    pyramid.height_ranges = q == 0 ? technique::HeightRanges(map->samples, pyramid.size)
                                   : technique::HeightRanges(pyramid.heights.download(), pyramid.size);
  return &pyramid;
}

Result<technique::Pyramids> Engine::pyramids(const Map& map, const std::set<int>& levels,
                                             const std::string& method) {
  technique::Pyramids built;
  for (const int q : levels) {
    const Result<const technique::Pyramid*> level =
        pyramid(map, q, technique::find_technique(method)->bounds);
    if (!level) return level.diagnostics();
    built[q] = *level;
  }
  return built;
}

Result<technique::Ground> Engine::ground(const Scene& scene, const Map& map, bool on_cpu, glm::dvec2 offset) {
  Result<technique::Ground> seen = points_of(scene, map, on_cpu, offset);
  if (seen) technique::leave_out_holes(*seen, *map);
  return seen;
}

Result<technique::Ground> Engine::points_of(const Scene& scene, const Map& map, bool on_cpu,
                                            glm::dvec2 offset) {
  if (const auto* camera = std::get_if<scene::MapCamera>(&scene.camera))
    return technique::map_ground(*camera, scene.shadow, *map);
  if (const auto* points = std::get_if<scene::PointsCamera>(&scene.camera)) {
    const Result<image::Image> image = image::read_image(points->path);
    if (!image) return image.diagnostics();
    return technique::points_ground(*image, points->path, scene.shadow, *map);
  }
  const auto& camera = std::get<scene::ViewCamera>(scene.camera);
  if (on_cpu) return technique::reference_ground(*map, camera, scene.shadow, offset);
  if (const Result<const gl::Info*> info = gl_info(); !info) return info.diagnostics();
  const Result<const technique::Pyramid*> base = pyramid(map, 0);
  if (!base) return in_scene(base.diagnostics(), scene);
  Result<technique::Ground> seen = technique::seen_ground(*programs_, **base, camera, scene.shadow, offset);
  if (!seen) return in_scene(seen.diagnostics(), scene);
  return seen;
}

Result<image::Image> Engine::render_with_gl(const Scene& scene, const Map& map,
                                            const technique::Ground& ground) {
  const Result<const gl::Info*> info = gl_info();
  if (!info) return info.diagnostics();
  const Result<technique::Pyramids> levels = pyramids(map, ground.levels(), scene.shadow.method);
  if (!levels) return in_scene(levels.diagnostics(), scene);
  Result<image::Image> image = technique::render_shadow(*programs_, *levels, scene, ground);
  if (!image) return in_scene(image.diagnostics(), scene);
  image->attributes["gnomon:renderer"] = (*info)->renderer + ", OpenGL " + (*info)->version;
  return image;
}

Result<image::Image> Engine::shadow(const Scene& scene, const Map& map, bool on_cpu,
                                    const technique::Ground& ground) {
  return on_cpu ? technique::reference_image(scene, *map, ground) : render_with_gl(scene, map, ground);
}

Result<Done> Engine::light(const Scene& scene, const Map& map, bool on_cpu, const technique::Ground& ground,
                           const technique::Albedo& albedo, image::Image& image) {
  const std::vector<glm::vec3> colours = technique::albedo_under(ground, albedo, *map);
  if (on_cpu) {
    technique::light_reference(*map, scene, ground, colours, image);
    return Done{};
  }
  const Result<const technique::Pyramid*> base = pyramid(map, 0);
  if (!base) return in_scene(base.diagnostics(), scene);
  return technique::light(*programs_, **base, scene, ground, colours, image);
}

Result<Done> Engine::show(const Scene& scene, const Map& map, bool on_cpu, const technique::Ground& centres,
                          image::Image& image) {
  const Result<technique::Albedo> albedo = technique::load_albedo(scene.ground);
  if (!albedo) return albedo.diagnostics();
  const int samples = std::get<scene::ViewCamera>(scene.camera).samples;
  if (samples == 1) return light(scene, map, on_cpu, centres, *albedo, image);
  SampleMean mean(image.pixels());
  for (int sample = 0; sample < samples; ++sample) {
    const Result<technique::Ground> points = ground(scene, map, on_cpu, sample_offset(sample));
    if (!points) return points.diagnostics();
    Result<image::Image> seen = shadow(scene, map, on_cpu, *points);
    if (!seen) return seen.diagnostics();
    if (const Result<Done> lit = light(scene, map, on_cpu, *points, *albedo, *seen); !lit) return lit;
    mean.add(*seen);
  }
  mean.store(image);
  return Done{};
}

bool Engine::on_cpu(const Scene& scene) const {
  return options_.backend == Backend::kCpu || technique::find_technique(scene.shadow.method)->program.empty();
}

Result<Rendered> Engine::render(const Scene& scene) {
  const Result<std::shared_ptr<const HeightMap>> map = terrain(scene);
  if (!map) return map.diagnostics();
  if (Diagnostics wrong = scene::check_size(scene, (*map)->width, (*map)->height); !wrong.empty())
    return wrong;
  const bool on_cpu = this->on_cpu(scene);
  if (is_named(options_)) {
    // Its absence is an error even where the method could do without.
    if (const Result<const gl::Info*> info = gl_info(); !info) return info.diagnostics();
  }
  Result<technique::Ground> points = ground(scene, *map, on_cpu);
  if (!points) return points.diagnostics();
  Result<image::Image> image = shadow(scene, *map, on_cpu, *points);
  if (!image) return image.diagnostics();
  if (std::get_if<scene::ViewCamera>(&scene.camera)) {
    if (const Result<Done> shown = show(scene, *map, on_cpu, *points, *image); !shown)
      return shown.diagnostics();
  }
  if (on_cpu) image->attributes["gnomon:renderer"] = "double-precision oracle";
  image->attributes["gnomon:terrain_hash"] = technique::hash_floats((*map)->samples);
  return Rendered{std::move(image).value(), std::move(points).value(), *map, terrain_->notes,
                  terrain_->georeference};
}

Result<image::Image> Engine::reference(const Scene& scene, const technique::Ground& ground,
                                       std::optional<int> level) {
  const Result<std::shared_ptr<const HeightMap>> map = terrain(scene);
  if (!map) return map.diagnostics();
  return technique::reference_image(scene, **map, ground, level);
}

Result<std::vector<float>> Engine::unsteady(const Scene& scene, const image::Image& image) {
  if (!std::get_if<scene::ViewCamera>(&scene.camera)) return std::vector<float>();
  const Result<std::shared_ptr<const HeightMap>> map = terrain(scene);
  if (!map) return map.diagnostics();
  std::vector<float> changes(image.pixels());
  constexpr double kStep = 1.0 / 64;
  for (const glm::dvec2 step : {glm::dvec2(kStep, 0), {-kStep, 0}, {0, kStep}, {0, -kStep}}) {
    const Result<technique::Ground> points = ground(scene, *map, on_cpu(scene), step);
    if (!points) return points.diagnostics();
    const Result<image::Image> moved = shadow(scene, *map, on_cpu(scene), *points);
    if (!moved) return moved.diagnostics();
    for (const char* name : {"valid", "q", "b_shadow"}) {
      const std::vector<float>&before = image.channels.at(name), &after = moved->channels.at(name);
      for (std::size_t i = 0; i < changes.size(); ++i) changes[i] = before[i] != after[i] ? 1.0F : changes[i];
    }
  }
  return changes;
}

image::Picture Engine::picture(const Rendered& rendered, const Scene& scene, const image::Image& image) {
  if (image.channel("R")) return technique::lit_picture(image);
  if (rendered.image.channel("R")) return technique::lit_picture(relit(rendered.image, image));
  if (!rendered.ground.depth.empty()) return technique::lit_picture(evenly_lit(image));
  const HeightMap& map = *rendered.map;
  const technique::Ground& ground = rendered.ground;
  std::vector<float> heights = heights_under(map, ground);
  const std::vector<float>* valid = image.channel("valid");
  for (std::size_t i = 0; valid && i < heights.size(); ++i)
    if ((*valid)[i] == 0) heights[i] = std::numeric_limits<float>::quiet_NaN();
  return image::hillshade(heights, ground.size.x, ground.size.y,
                          map.spacing_x * double{ground.texels_per_pixel.x},
                          map.spacing_y * double{ground.texels_per_pixel.y}, image.channels.at("k_shadow"),
                          scene.sun.azimuth, scene.sun.elevation);
}

}  // namespace gnomon
