// SPDX-License-Identifier: MIT
// Turns scenes into images: terrain, context, programs and pyramid, each made once and kept for the next
// scene.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "gl/context.h"
#include "gnomon/diagnostic.h"
#include "image/image.h"
#include "scene/scene.h"
#include "technique/albedo.h"
#include "technique/ground.h"
#include "technique/program_cache.h"
#include "technique/pyramid.h"
#include "technique/renderer.h"
#include "technique/technique.h"
#include "terrain/georeference.h"
#include "terrain/height_map.h"

namespace gnomon {

enum class Backend {
  kAuto,    ///< hardware by EGL, else software by EGL, else OSMesa
  kEgl,     ///< OpenGL by EGL, hardware first
  kOsmesa,  ///< OpenGL by OSMesa
  kCpu      ///< no GL: every scene is answered by the oracle
};

struct EngineOptions {
  std::string shader_library;         ///< folder of the modules
  std::vector<std::string> includes;  ///< further folders, before the library
  std::string target = "glsl450";     ///< dialect that the modules are assembled in
  Backend backend = Backend::kAuto;
  std::string
      device{};  ///< which of the devices of `gnomon info`, by number or name; empty: by the back end's order
};

/// What a render shows and what it was made from.
struct Rendered {
  image::Image image;
  technique::Ground ground;  ///< the points that were asked
  std::shared_ptr<const terrain::HeightMap> map;
  std::vector<std::string> notes;  ///< what a user should know, such as where the spacing is from
  std::optional<terrain::Georeference> georeference{};  ///< of the map
};

class Engine {
 public:
  explicit Engine(EngineOptions options) : options_(std::move(options)) {}
  Engine(Engine&&) = default;
  Engine& operator=(Engine&&) = delete;
  ~Engine();

  /// The scene's image by its own method; attributes tell what made it (scene, shader and program hash,
  /// renderer).
  [[nodiscard]] Result<Rendered> render(const scene::Scene& scene);

  /// What the oracle answers for the points of a render; from level `level`, or from each point's own.
  [[nodiscard]] Result<image::Image> reference(const scene::Scene& scene, const technique::Ground& ground,
                                               std::optional<int> level = {});

  /// 1 for each pixel of a render whose `valid`, `q` or `b_shadow` change when its ray moves by 1/64 pixel:
  /// there another renderer's rounding may decide otherwise. Empty for cameras without rays.
  [[nodiscard]] Result<std::vector<float>> unsteady(const scene::Scene& scene, const image::Image& image);

  /// The relief under the scene's camera as a person would look at it, with the shadows of `image` and its
  /// holes.
  [[nodiscard]] static image::Picture picture(const Rendered& rendered, const scene::Scene& scene,
                                              const image::Image& image);

  /// The context, made at its first use and current after each. Fails with kMachine where there is none as
  /// `backend` and `device` ask for.
  [[nodiscard]] Result<const gl::Info*> gl_info();

  /// For bench: the map of a scene, the programs, the pyramid.
  [[nodiscard]] Result<std::shared_ptr<const terrain::HeightMap>> terrain(const scene::Scene& scene);
  [[nodiscard]] Result<const technique::Pyramid*> pyramid(
      const std::shared_ptr<const terrain::HeightMap>& map, int q,
      technique::Bounds bounds = technique::Bounds::kBlockMaxima);
  /// Those of all these levels, with what the method reads.
  [[nodiscard]] Result<technique::Pyramids> pyramids(const std::shared_ptr<const terrain::HeightMap>& map,
                                                     const std::set<int>& levels, const std::string& method);
  [[nodiscard]] technique::ProgramCache& programs() { return *programs_; }

 private:
  struct LoadedTerrain {
    scene::Terrain source;
    std::shared_ptr<const terrain::HeightMap> map;
    std::vector<std::string> notes;
    std::optional<terrain::Georeference> georeference;
  };
  /// The levels that have been asked for, of one map.
  struct BuiltPyramids {
    std::shared_ptr<const terrain::HeightMap> map;
    std::map<int, technique::Pyramid> levels;
  };
  using Map = std::shared_ptr<const terrain::HeightMap>;

  /// The points that the scene's camera asks for, whether or not there is a surface.
  [[nodiscard]] Result<technique::Ground> points_of(const scene::Scene& scene, const Map& map, bool on_cpu,
                                                    glm::dvec2 offset);
  /// Whether the scene is answered without GL.
  [[nodiscard]] bool on_cpu(const scene::Scene& scene) const;
  /// The points that the scene's camera sees, its rays `offset` pixels beside the pixels' centres.
  [[nodiscard]] Result<technique::Ground> ground(const scene::Scene& scene, const Map& map, bool on_cpu,
                                                 glm::dvec2 offset = {});
  /// The shadow of these points.
  [[nodiscard]] Result<image::Image> shadow(const scene::Scene& scene, const Map& map, bool on_cpu,
                                            const technique::Ground& ground);
  /// Adds R, G and B.
  [[nodiscard]] Result<Done> light(const scene::Scene& scene, const Map& map, bool on_cpu,
                                   const technique::Ground& ground, const technique::Albedo& albedo,
                                   image::Image& image);
  /// What a perspective or orthographic camera adds to the shadow of its pixels' centres: the lit image, and
  /// with several samples a pixel their means.
  [[nodiscard]] Result<Done> show(const scene::Scene& scene, const Map& map, bool on_cpu,
                                  const technique::Ground& centres, image::Image& image);
  [[nodiscard]] Result<image::Image> render_with_gl(const scene::Scene& scene, const Map& map,
                                                    const technique::Ground& ground);

  EngineOptions options_;
  std::optional<gl::Context> context_;  // outlives everything below
  std::optional<technique::ProgramCache> programs_;
  std::optional<LoadedTerrain> terrain_;
  BuiltPyramids pyramids_;
};

}  // namespace gnomon
