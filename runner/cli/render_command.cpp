// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "cli/commands.h"
#include "engine.h"
#include "image/animation.h"
#include "image/image.h"
#include "scene/project.h"
#include "scene/sun_at_time.h"
#include "terrain/geotiff.h"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

/// The sun by --time, --at and the map's georeference; what is wrong with them, or nothing.
std::optional<Diagnostic> set_time(const RenderArguments& a, scene::Scene& scene) {
  if (!a.time) return std::nullopt;
  scene::SunTime time{.time = *a.time};
  if (a.at) {
    const auto [latitude, longitude] = *a.at;
    if (std::abs(latitude) > 90 || std::abs(longitude) > 180) {
      return Diagnostic{.file = "--at",
                        .message =
                            "a latitude lies between -90 and 90 degrees, a longitude between -180 and "
                            "180; the latitude comes first"};
    }
    time.place = ephemeris::Place{latitude, longitude};
  }
  const scene::Vocabulary words = vocabulary();
  const std::optional<scene::SunOnMap> sun = scene::sun_at(time, scene::map_centre(scene.terrain, words));
  // A file that cannot be read is refused, with its reason, when it is loaded.
  if (!sun && !words.file_size(std::get<scene::FileTerrain>(scene.terrain.source))) return std::nullopt;
  if (!sun) {
    return Diagnostic{.file = "--time",
                      .message =
                          "the height map does not say where on the earth it lies: add --at LAT,LON, in "
                          "degrees north and east, such as --at 47.4,8.5"};
  }
  scene.sun = sun->sun;
  scene.notes.push_back(sun->note);
  return std::nullopt;
}

/// A scene around an image of heights, with what the options say and defaults for the rest.
Result<scene::Scene> scene_of_height_map(const RenderArguments& a) {
  scene::Scene scene;
  scene.id = fs::path(a.heightmap).stem().string();
  scene.file = a.heightmap;
  scene.terrain.source =
      scene::FileTerrain{.path = a.heightmap, .channel = a.channel, .raw = a.raw, .nodata = a.nodata};
  scene.terrain.spacing = a.spacing;
  scene.terrain.vertical_scale = a.vertical_scale;
  if (a.spacing && std::min((*a.spacing)[0], (*a.spacing)[1]) <= 0) {
    return Diagnostic{.file = "--spacing", .message = "has to be above 0 metres"};
  }
  if (a.sun) {
    const auto [azimuth, elevation] = *a.sun;
    if (elevation < -90 || elevation > 90) {
      return Diagnostic{.file = "--sun", .message = "an elevation lies between -90 and 90 degrees"};
    }
    scene.sun = {.azimuth = azimuth - 360.0 * std::floor(azimuth / 360.0), .elevation = elevation};
  }
  if (std::optional<Diagnostic> problem = set_time(a, scene)) return *problem;
  if (a.size && (std::min((*a.size)[0], (*a.size)[1]) < 1 || std::max((*a.size)[0], (*a.size)[1]) > 16384)) {
    return Diagnostic{.file = "--size", .message = "each side has to be 1 to 16384 pixels"};
  }
  scene.camera = scene::MapCamera{.size = a.size};
  scene.shadow.method = a.method.value_or(scene.shadow.method);
  scene.shadow.q = a.q.value_or(0);
  scene.shadow.receiver_height = a.receiver_height.value_or(0.0);
  return scene;
}

struct Loaded {
  std::vector<scene::Scene> scenes;
  Diagnostics diagnostics;
};

Loaded load(const RenderArguments& a) {
  if (!a.heightmap.empty()) {
    Result<scene::Scene> scene = scene_of_height_map(a);
    if (!scene) return {{}, scene.diagnostics()};
    return {{std::move(scene).value()}, {}};
  }
  scene::LoadResult loaded = scene::load_scene(a.scene, a.overrides, vocabulary());
  return {std::move(loaded.tests), std::move(loaded.diagnostics)};
}

/// "o.exr", or "o@elevation=10.exr" where a matrix makes several images of one scene.
std::string output_of(const RenderArguments& a, const scene::Scene& scene, bool several) {
  const std::size_t at = scene.id.find('@');
  if (!several || at == std::string::npos) return a.output;
  const fs::path path(a.output);
  return (path.parent_path() / (path.stem().string() + scene.id.substr(at) + path.extension().string()))
      .string();
}

/// "o.gif" beside "o@frame=0007.exr", one for all frames of a path.
std::string preview_of(const RenderArguments& a, const scene::Scene& scene) {
  std::string suffix = scene.id.substr(scene.id.find('@'));
  suffix.resize(suffix.rfind("frame=") - 1);  // with the "@" or "," before it
  const fs::path path(a.output);
  return (path.parent_path() / (path.stem().string() + suffix + ".gif")).string();
}

std::string extension_of(const std::string& path) {
  std::string extension = fs::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return extension;
}

/// How far a soft method covers the sun, else the shadow; nodata without a surface. What the map camera sees
/// lies over the map.
Result<Done> write_tiff(const std::string& path, const Rendered& rendered, const scene::Scene& scene) {
  const image::Image& image = rendered.image;
  const std::vector<float>* occlusion = image.channel("occlusion");
  std::vector<float> values = occlusion ? *occlusion : image.channels.at("b_shadow");
  const std::vector<float>& valid = image.channels.at("valid");
  for (std::size_t i = 0; i < values.size(); ++i)
    if (valid[i] == 0) values[i] = terrain::kTiffNodata;
  std::optional<terrain::Georeference> georeference;
  if (rendered.georeference && std::get_if<scene::MapCamera>(&scene.camera))
    georeference = terrain::resized(*rendered.georeference, rendered.map->width, rendered.map->height,
                                    image.width, image.height);
  return terrain::write_geotiff(path, image.width, image.height, values, georeference);
}

Result<Done> write(const std::string& path, const Rendered& rendered, const scene::Scene& scene) {
  const std::string extension = extension_of(path);
  if (extension == ".exr") return image::write_exr(path, rendered.image);
  if (extension == ".png") {
    return image::write_png(path, Engine::picture(rendered, scene, rendered.image));
  }
  return write_tiff(path, rendered, scene);
}

/// Whether two names lead to one file, links followed.
bool same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  return fs::equivalent(a, b, error);
}

bool overwrites_input(const std::string& output, const scene::Scene& scene) {
  const auto* file = std::get_if<scene::FileTerrain>(&scene.terrain.source);
  return same_file(output, scene.file) || (file && same_file(output, file->path));
}

/// What is about to be overwritten although it is rendered from, or nothing.
std::optional<Diagnostic> overwriting(const RenderArguments& a, const std::vector<scene::Scene>& scenes) {
  for (const scene::Scene& scene : scenes) {
    std::vector<std::string> paths{output_of(a, scene, scenes.size() > 1)};
    if (scene.frame) paths.push_back(preview_of(a, scene));
    for (const std::string& path : paths) {
      if (overwrites_input(path, scene))
        return Diagnostic{.file = path, .message = "is what is rendered from: write to another file"};
    }
  }
  return std::nullopt;
}

/// The animated preview of a path, from its first frame to its last.
class Preview {
 public:
  /// Returns the path of the file that was written with the last frame, else "".
  Result<std::string> add(const std::string& path, const scene::Frame& frame, const image::Picture& picture) {
    if (frame.number == 0) animation_.emplace(path, frame.rate);
    if (const Result<Done> added = animation_->add(picture); !added) return added.diagnostics();
    if (frame.number + 1 < frame.count) return std::string();
    if (const Result<Done> written = animation_->write(); !written) return written.diagnostics();
    return path;
  }

 private:
  std::optional<image::Animation> animation_;
};

/// Renders a scene and writes what it shows; prints the paths of what was written.
Result<Done> render(Engine& engine, const RenderArguments& arguments, const scene::Scene& scene, bool several,
                    Preview& preview, Console& console) {
  const Result<Rendered> rendered = engine.render(scene);
  if (!rendered) return rendered.diagnostics();
  for (const std::string& note : scene.notes) console.err << note << "\n";
  for (const std::string& note : rendered->notes) console.err << note << "\n";
  const std::string path = output_of(arguments, scene, several);
  if (const Result<Done> written = write(path, *rendered, scene); !written) return written;
  console.out << path << "\n";
  if (!scene.frame) return Done{};
  const Result<std::string> finished = preview.add(preview_of(arguments, scene), *scene.frame,
                                                   Engine::picture(*rendered, scene, rendered->image));
  if (!finished) return finished.diagnostics();
  if (!finished->empty()) console.out << *finished << "\n";
  return Done{};
}

bool known_output(const std::string& path) {
  const std::string extension = extension_of(path);
  return extension == ".exr" || extension == ".png" || extension == ".tif" || extension == ".tiff";
}

}  // namespace

int run_command(const RenderArguments& arguments, Console& console) {
  if (!known_output(arguments.output)) {
    return report(console, {{.file = arguments.output,
                             .message = "what to write follows from the ending: .exr, .png or .tif"}});
  }
  const Loaded loaded = load(arguments);
  if (const int code = report(console, loaded.diagnostics); code != 0) return code;
  const Result<scene::Project> project = scene::find_project(arguments.scene.empty() ? "." : arguments.scene);
  if (!project && !arguments.scene.empty()) return report(console, project.diagnostics());
  if (const auto refusal = overwriting(arguments, loaded.scenes)) return report(console, {*refusal});
  Engine engine({.shader_library = console.shader_library,
                 .includes = project ? project->includes : std::vector<std::string>{},
                 .target = arguments.target,
                 .backend = arguments.backend,
                 .device = arguments.device});
  Preview preview;
  std::size_t written_count = 0;
  for (const scene::Scene& scene : loaded.scenes) {
    if (console.interrupted) {
      console.err << "interrupted: " << written_count << " of " << loaded.scenes.size()
                  << " images were written\n";
      return static_cast<int>(Failure::kInterrupted);
    }
    const bool several = loaded.scenes.size() > 1;
    const Result<Done> written = render(engine, arguments, scene, several, preview, console);
    if (!written) return report(console, written.diagnostics());
    ++written_count;
  }
  return 0;
}

}  // namespace gnomon::cli
