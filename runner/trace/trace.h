// SPDX-License-Identifier: MIT
// The shadow ray of one pixel, step by step: what the shader modules visit, run as C++, and why they go on.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "scene/scene.h"
#include "technique/ground.h"
#include "terrain/height_map.h"

namespace gnomon::trace {

/// What a look at a patch, a block or a texel came to.
enum class Decision {
  kSkips,     ///< the block lies at or below the ray
  kDescends,  ///< the block's bound lies above the ray: look closer
  kPasses,    ///< nothing in the patch rises above the ray
  kHole,      ///< the patch has no surface
  kTouches,   ///< the ray has no length in the patch
  kHides,     ///< the surface rises above the ray: shadow
  kLowest,    ///< multilevel_literal: the block's lowest height rises to the ray: shadow
};
[[nodiscard]] std::string name_of(Decision decision);

/// Entry and exit of the ray.
using Span = std::array<double, 2>;

struct Step {
  int number = 0;    ///< from 1
  int level = 0;     ///< of the block; 0: a single patch, or texel
  glm::ivec2 index;  ///< of the block, patch or texel at that level
  Span t{};          ///< along the ray, in its own unit (docs/cli.md)
  Span distance{};   ///< metres on the ground
  Span ray{};        ///< height of the ray, metres
  /// Highest (and lowest, where the method has one) height that bounds the block, metres; nothing where the
  /// block has no sample, and for a patch.
  std::optional<double> highest{};
  std::optional<double> lowest{};
  std::optional<Span> surface{};  ///< of a patch that has one: height at entry and exit, metres
  Decision decision = Decision::kPasses;
  std::string reason{};     ///< in words, with what comes next
  bool other_side = false;  ///< of a walk repeated on the other side of the edges that the ray runs along
};

/// What a perspective or orthographic camera's ray meets of the surface itself.
struct ViewHit {
  double depth = 0;  ///< metres along the ray
  int steps = 0;     ///< patches and blocks that the view ray visited
  /// The oracle's hit, column and row, where it sees anything.
  std::optional<std::array<double, 2>> oracle{};
};

/// The triangle of a mesh that a ray meets.
struct Triangle {
  std::array<double, 2> at{};  ///< column and row of the place
  Span columns{};              ///< of its cell, texels of the map from the west edge
  Span rows{};                 ///< likewise, from the north edge
  bool north_western = false;  ///< else the south-eastern half of the cell
};

/// What the ray of a camera that shows a mesh meets, in double precision.
struct MeshView {
  double depth = 0;                    ///< metres along the ray, 0 where it meets nothing
  std::optional<Triangle> triangle{};  ///< where it meets one
};

/// Where a pixel's shadow is asked.
struct Point {
  technique::Ground ground;  ///< of this pixel alone
  glm::ivec2 image_size{};
  std::optional<ViewHit> view{};   ///< of a camera that shows the surface itself
  std::optional<MeshView> mesh{};  ///< of one that shows a mesh
  [[nodiscard]] bool valid() const { return ground.valid[0] != 0; }
};

struct Walk {
  std::vector<Step> steps{};
  float shadow = 0;  ///< b_shadow
  int count = 0;     ///< the channel `steps`
  int cause = 0;     ///< GNOMON_CAUSE_...
  int step_limit = 0;
  double height = 0;  ///< metres: where the ray starts

  [[nodiscard]] bool decided() const { return cause != 0; }
};

/// What the oracle says of the same pixel.
struct OracleAnswer {
  double horizon = 0;  ///< radians, -pi/2 where nothing lies ahead
  bool shadow = false;
  bool in_band = false;
};

struct Trace {
  glm::ivec2 pixel{};
  Point point;
  std::optional<Walk> walk{};  ///< where the pixel has a surface
  OracleAnswer oracle;
};

/// The methods whose steps can be told.
[[nodiscard]] const std::vector<std::string>& traceable_methods();

/// Traces pixel (x, y) of the scene, whose terrain is `base`. Fails where the image has no such pixel, the
/// method walks no ray, or an image of points cannot be read; with kFailed where what the walk did and what
/// is told of it differ, which is a fault of gnomon.
[[nodiscard]] Result<Trace> trace_pixel(const scene::Scene& scene, const terrain::HeightMap& base,
                                        glm::ivec2 pixel);

/// A table for people: a header, a line a step, the verdict.
[[nodiscard]] std::string to_text(const Trace& trace, const scene::Scene& scene);

/// The same for programs; docs/cli.md lists the keys.
[[nodiscard]] std::string to_json(const Trace& trace, const scene::Scene& scene);

/// What a walk ended with: one word for programs, and in words.
[[nodiscard]] std::string cause_name(int cause);
[[nodiscard]] std::string cause_text(int cause);

}  // namespace gnomon::trace
