// SPDX-License-Identifier: MIT
#include "engine.h"

#include <algorithm>
#include <utility>

#include "image/hillshade.h"
#include "oracle/oracle.h"
#include "scene/load.h"
#include "technique/hash.h"
#include "technique/reference.h"
#include "technique/renderer.h"
#include "technique/surface.h"
#include "technique/technique.h"
#include "technique/view.h"
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

struct MakeTerrain {
  const scene::Terrain& terrain;

  Result<LoadedHeightMap> operator()(const scene::FileTerrain& file) const {
    return terrain::load_height_map(
        file.path,
        {.spacing = terrain.spacing, .vertical_scale = terrain.vertical_scale, .channel = file.channel});
  }

  Result<LoadedHeightMap> operator()(const scene::InlineTerrain& table) const {
    const auto [x, y] = spacing_of(terrain);
    HeightMap map{.width = table.width,
                  .height = table.height,
                  .spacing_x = x,
                  .spacing_y = y,
                  .domain_width = double(table.width),
                  .domain_height = double(table.height)};
    std::transform(table.heights.begin(), table.heights.end(), std::back_inserter(map.samples),
                   [&](double stored) { return static_cast<float>(stored * terrain.vertical_scale); });
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
                                                      .vertical_scale = terrain.vertical_scale,
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

/// The heights under the pixels of a view, for pictures.
std::vector<float> heights_under(const HeightMap& map, const technique::MapView& view) {
  if (view.on_samples()) return map.samples;
  const oracle::Surface surface = technique::surface_of(map);
  std::vector<float> heights;
  for (int y = 0; y < view.size.y; ++y) {
    for (int x = 0; x < view.size.x; ++x) {
      heights.push_back(static_cast<float>(oracle::surface_height(surface, view.column(x), view.row(y))));
    }
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
                           std::move(loaded->notes)};
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

Result<const technique::Pyramid*> Engine::pyramid(const std::shared_ptr<const HeightMap>& map, int q,
                                                  technique::Bounds bounds) {
  if (!pyramid_ || pyramid_->map != map || pyramid_->pyramid.q != q) {
    pyramid_.reset();  // first: two large pyramids need not fit
    Result<technique::Pyramid> built = technique::build_pyramid(*programs_, *map, q);
    if (!built) return built.diagnostics();
    pyramid_ = BuiltPyramid{map, std::move(built).value()};
  }
  if (bounds == technique::Bounds::kLiteralExtrema && !pyramid_->pyramid.literal_extrema) {
    auto literal = technique::build_literal_extrema(*programs_, *map);
    if (!literal) return literal.diagnostics();
    pyramid_->pyramid.literal_extrema = std::move(literal).value();
  }
  return &pyramid_->pyramid;
}

Result<image::Image> Engine::render_with_gl(const Scene& scene, const std::shared_ptr<const HeightMap>& map) {
  const Result<const gl::Info*> info = gl_info();
  if (!info) return info.diagnostics();
  const Result<const technique::Pyramid*> built =
      pyramid(map, scene.shadow.q, technique::find_technique(scene.shadow.method)->bounds);
  if (!built) return in_scene(built.diagnostics(), scene);
  Result<image::Image> image = technique::render_shadow(*programs_, **built, scene, *map);
  if (!image) return in_scene(image.diagnostics(), scene);
  image->attributes["gnomon:renderer"] = (*info)->renderer + ", OpenGL " + (*info)->version;
  return image;
}

Result<Rendered> Engine::render(const Scene& scene) {
  const Result<std::shared_ptr<const HeightMap>> map = terrain(scene);
  if (!map) return map.diagnostics();
  if (Diagnostics wrong = scene::check_size(scene, (*map)->width, (*map)->height); !wrong.empty())
    return wrong;
  const bool on_cpu =
      options_.backend == Backend::kCpu || technique::find_technique(scene.shadow.method)->program.empty();
  if (is_named(options_)) {
    // Its absence is an error even where the method could do without.
    if (const Result<const gl::Info*> info = gl_info(); !info) return info.diagnostics();
  }
  Result<image::Image> image = on_cpu ? reference(scene, scene.shadow.q) : render_with_gl(scene, *map);
  if (!image) return image.diagnostics();
  if (on_cpu) image->attributes["gnomon:renderer"] = "double-precision oracle";
  image->attributes["gnomon:terrain_hash"] = technique::hash_floats((*map)->samples);
  return Rendered{std::move(image).value(), *map, terrain_->notes};
}

Result<image::Image> Engine::reference(const Scene& scene, int level) {
  const Result<std::shared_ptr<const HeightMap>> map = terrain(scene);
  if (!map) return map.diagnostics();
  return technique::reference_image(scene, **map, level);
}

image::Picture Engine::picture(const HeightMap& map, const Scene& scene, const std::vector<float>& k_shadow) {
  const technique::MapView view = technique::map_view(scene.camera, map);
  return image::hillshade(
      heights_under(map, view), view.size.x, view.size.y, map.spacing_x * double{view.texels_per_pixel.x},
      map.spacing_y * double{view.texels_per_pixel.y}, k_shadow, scene.sun.azimuth, scene.sun.elevation);
}

}  // namespace gnomon
