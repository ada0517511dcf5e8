// SPDX-License-Identifier: MIT
// A validated scene: what a test renders and what it expects. A Scene that exists is valid.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ephemeris/sun_position.h"
#include "terrain/raw_layout.h"

namespace gnomon::scene {

struct FileTerrain {
  /// Ready to open: absolute or relative to the working directory; inside the scene's root.
  std::string path;
  std::optional<std::string> channel{};
  std::optional<terrain::RawLayout> raw{};  ///< the file is bare numbers that lie so
  std::optional<double> nodata{};           ///< stored number that means "no data"
  friend bool operator==(const FileTerrain&, const FileTerrain&) = default;
};
struct InlineTerrain {
  int width = 0, height = 0;
  /// What a height is that is null in the scene: there is no data. (Not NaN, so that equal maps compare
  /// equal.)
  static constexpr double kNull = -std::numeric_limits<double>::infinity();
  std::vector<double>
      heights;  ///< row-major, north row first, stored units (times vertical_scale: metres) or kNull
  friend bool operator==(const InlineTerrain&, const InlineTerrain&) = default;
};
struct ProceduralTerrain {
  std::string kind;
  int width = 256, height = 256;
  std::uint32_t seed = 0;
  std::map<std::string, double> parameters;
  friend bool operator==(const ProceduralTerrain&, const ProceduralTerrain&) = default;
};

struct Terrain {
  std::variant<FileTerrain, InlineTerrain, ProceduralTerrain> source;
  std::optional<std::array<double, 2>> spacing;  ///< metres per sample (x, y); absent: the file's own, or 1 m
  std::optional<double> vertical_scale;          ///< metres per stored unit; absent: the file's own, or 1
  friend bool operator==(const Terrain&, const Terrain&) = default;
};

/// When and where the sun was asked for.
struct SunTime {
  ephemeris::Utc time;
  std::optional<ephemeris::Place> place{};  ///< absent: the middle of the map
  bool refraction = false;                  ///< whether the elevation is that which the air shows
};

/// Angles in degrees. A direction or a time `load` has turned into them.
struct Sun {
  double azimuth = 315.0;         ///< degrees clockwise from grid north, in [0, 360)
  double elevation = 45.0;        ///< degrees above the horizon, in [-90, 90]
  std::optional<SunTime> time{};  ///< what they follow from, if it is that
};

/// One pixel per height sample, or `size` pixels over the whole map.
struct MapCamera {
  std::optional<std::array<int, 2>> size;  ///< width, height in pixels
};

/// The ground drawn as triangles: a node on every `step`-th sample.
struct MeshSurface {
  int step = 1;
  bool cull_back_faces = true;
};

/// A camera somewhere in the world; up is +z, or north where it looks straight up or down.
struct ViewCamera {
  enum class Projection { kPerspective, kOrthographic };
  Projection projection = Projection::kPerspective;
  std::array<double, 3> eye{};        ///< metres
  std::array<double, 3> target{};     ///< metres, not the eye: the point in the middle of the image
  double extent = 45.0;               ///< of the image from top to bottom: degrees (perspective) or metres
  std::array<int, 2> size{640, 360};  ///< width, height in pixels
  int samples = 1;                    ///< a pixel
  std::optional<MeshSurface> mesh{};  ///< absent: the bilinear surface itself
};

/// Asks again at the channels `column` and `row` of another image.
struct PointsCamera {
  std::string path;        ///< ready to open
  std::string below_root;  ///< of the project
};

using Camera = std::variant<MapCamera, ViewCamera, PointsCamera>;

/// Of the method cascaded_shadow_maps.
struct Cascades {
  enum class Faces { kAll, kFront, kBack };
  int count = 4;        ///< 1..4
  int size = 2048;      ///< texels a side of each
  double split = 0.75;  ///< 0: slices of equal depth; 1: of equal ratio
  std::optional<double>
      distance{};             ///< metres of depth to which maps are fitted; absent: all that is visible
  double bias = 0.5;          ///< texels
  double slope_bias = 0.5;    ///< texels for each tangent of the angle between sun and normal
  int filter = 3;             ///< texels a side: 1, 3, 5 or 7
  bool stable = true;         ///< maps change their size seldom and snap to whole texels
  Faces faces = Faces::kAll;  ///< that are drawn into the maps
  int step = 1;               ///< of the mesh, samples
};

struct Shadow {
  std::string method = "multilevel";
  /// Level of detail; absent ("auto"): for each pixel by Algo 1 of the 2022 paper.
  std::optional<int> q = 0;
  int max_anisotropy =
      16;  ///< of "auto": n_a_max, texels across a pixel's longer axis for each on the shorter
  double k_dark = 0.2;
  double k_bright = 0.6;
  double receiver_height = 0.0;  ///< metres above the surface of the level, >= 0
  Cascades cascades;
};

using Colour = std::array<double, 3>;  ///< linear red, green, blue, 0..1

struct ConstantAlbedo {
  Colour colour{0.45, 0.42, 0.36};
};
/// Laid over the whole map, row 0 in the north.
struct ImageAlbedo {
  std::string path;        ///< ready to open
  std::string below_root;  ///< of the project
};
/// Between two heights linearly, beyond the outermost their colours.
struct HeightAlbedo {
  std::vector<std::pair<double, Colour>> colours;  ///< metres, rising
};

/// How cameras other than map show the ground.
struct Ground {
  std::variant<ConstantAlbedo, ImageAlbedo, HeightAlbedo> albedo;
  double ambient = 0.15;  ///< share of the light that comes from everywhere
};

struct GoldenExpectation {
  double max_mismatch = 0;
  std::map<std::string, double> tolerance;  ///< absolute, by channel; absent: 0
  bool band = true;
  std::optional<std::string> unproven;
};
struct ReferenceExpectation {
  double max_mismatch = 0;
  std::optional<std::array<double, 2>> mismatch;  ///< a share in [min, max] that is known to be wrong
  std::optional<int> level;
};
struct ProbeExpectation {
  int x = 0, y = 0;
  std::map<std::string, double> values;  ///< by channel
};
struct MaxStepsExpectation {
  double limit = 0;
};
using Expectation =
    std::variant<GoldenExpectation, ReferenceExpectation, ProbeExpectation, MaxStepsExpectation>;

/// Which frame of a path a scene is.
struct Frame {
  int number = 0;    ///< from 0
  int count = 1;     ///< of the path
  double rate = 10;  ///< frames a second, of the preview
};

struct Scene {
  std::string id;           ///< "a/b" or "a/b@elevation=10,q=2"
  std::string file;         ///< the scene file, as given
  std::string golden_file;  ///< where this test's golden lives, whether or not it exists
  std::string description;
  /// What determines the image, after matrix and --set, defaults filled in, keys sorted: what the scene hash
  /// covers. Without description and expectations; a terrain file is named by its path below the root, its
  /// content is not in it.
  std::string canonical_json;
  /// The --set arguments (KEY=VALUE) that were applied, for the reproduce command.
  std::vector<std::string> overrides;
  std::vector<std::string> notes;  ///< what a user should know, such as where the sun stands by its time
  Terrain terrain;
  Sun sun;
  Camera camera;
  Shadow shadow;
  Ground ground;
  std::vector<Expectation> expect;
  std::optional<Frame> frame;
};

}  // namespace gnomon::scene
