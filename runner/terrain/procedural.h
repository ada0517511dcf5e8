// SPDX-License-Identifier: MIT
// Procedural height maps, seeded and identical to the bit on every machine (integer hash; + - * / only).
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
  std::string unit;         ///< "m", "texel", "1", ...
  std::string description;  ///< one sentence
};

/// A kind of procedural map, for the schema, the docs and error messages.
struct ProceduralKind {
  std::string name;         ///< flat plane wall step steps cone spikes posts crater gorge checker fractal
  std::string description;  ///< one sentence
  std::vector<ProceduralParameter> parameters;
};

[[nodiscard]] const std::vector<ProceduralKind>& procedural_kinds();

struct ProceduralRequest {
  std::string kind;
  int width = 256;
  int height = 256;
  std::uint32_t seed = 0;
  double spacing_x = 1.0;  ///< metres
  double spacing_y = 1.0;  ///< metres
  double vertical_scale = 1.0;  ///< multiplies the heights, once, in double
  std::map<std::string, double> parameters;  ///< by ProceduralParameter::name; absent ones take the kind's default
};

/// Fails for an unknown kind or parameter (naming the known ones) or a parameter out of range.
[[nodiscard]] Result<HeightMap> make_procedural(const ProceduralRequest& request);

}  // namespace gnomon::terrain
