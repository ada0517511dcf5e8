// SPDX-License-Identifier: MIT
// The table of shadow methods. A new one is a program in shaderlib/programs and a row here.
#pragma once

#include <string>
#include <vector>

namespace gnomon::technique {

/// What a method reads beside the heights of its level.
enum class Bounds {
  kBlockMaxima,     ///< relief/extrema: maxima over blocks of patches of H_q
  kLiteralExtrema,  ///< relief/literal_extrema: the papers' H_ext, of H_0 whatever q is
  kCascades,        ///< what the sun sees of a mesh of H_q, drawn anew for each image
};

struct Technique {
  std::string name;  ///< what scenes and --method call it
  std::string
      program;  ///< fragment program below the shader library; empty: computed on the CPU by the oracle
  std::string description;  ///< one sentence
  Bounds bounds = Bounds::kBlockMaxima;
  bool exact = true;  ///< equals the oracle outside the band
};

/// Every method, the default one first.
[[nodiscard]] const std::vector<Technique>& techniques();

/// The method of that name, or null.
[[nodiscard]] const Technique* find_technique(const std::string& name);

}  // namespace gnomon::technique
