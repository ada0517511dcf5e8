// SPDX-License-Identifier: MIT
// Procedural height maps, seeded and identical to the bit on every machine (integer hash; + - * / and sqrt
// only).
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gnomon/diagnostic.h"
#include "terrain/height_map.h"

namespace gnomon::terrain {

/// One parameter of a procedural map; all are optional in a scene.
struct ProceduralParameter {
  std::string name;
  std::string unit;           ///< "m", "texel", "1", ...
  std::string description;    ///< one sentence
  std::string default_value;  ///< for a person: "20", "0.1 x width x spacing"
  double minimum = 0;         ///< inclusive
  double maximum = 0;         ///< inclusive
  bool whole = false;         ///< only whole numbers are accepted
};

/// A kind of procedural map, for the schema, the docs and error messages.
struct ProceduralKind {
  std::string name;         ///< flat plane wall step steps cone spikes posts crater gorge checker fractal
  std::string description;  ///< one sentence
  std::vector<ProceduralParameter> parameters;
};

/// Every kind with its parameters. All kinds end with `mirror` and `quarter_turns`, which turn the finished
/// map.
[[nodiscard]] const std::vector<ProceduralKind>& procedural_kinds();

/// Longest side that is made.
constexpr int kLargestProceduralSize = 16384;

struct ProceduralRequest {
  std::string kind;
  int width = 256;   ///< samples, 1..kLargestProceduralSize
  int height = 256;  ///< samples, 1..kLargestProceduralSize
  std::uint32_t seed = 0;
  double spacing_x = 1.0;       ///< metres
  double spacing_y = 1.0;       ///< metres
  double vertical_scale = 1.0;  ///< multiplies the heights, once, in double
  std::map<std::string, double>
      parameters;  ///< by ProceduralParameter::name; absent ones take the kind's default
};

/// Fails for an unknown kind or parameter (naming the known ones), a size, spacing or parameter out of range,
/// or heights that overflow float.
[[nodiscard]] Result<HeightMap> make_procedural(const ProceduralRequest& request);

}  // namespace gnomon::terrain
