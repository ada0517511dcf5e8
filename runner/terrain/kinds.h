// SPDX-License-Identifier: MIT
// The table of procedural kinds: a new kind is a generator and one row here. Internal to this folder.
#pragma once

#include <string_view>
#include <vector>

#include "terrain/generator.h"

namespace gnomon::terrain {

/// What a default is a multiple of, so that a map of any size and spacing looks the same.
enum class Measure { kOne, kWidthMetres, kShorterSideMetres, kWidthTexels, kMiddleColumn, kMiddleRow };

struct ParameterRule {
  const char* name;
  const char* unit;
  const char* description;
  double factor;  ///< the default is factor * measure
  Measure measure;
  double minimum;
  double maximum;
  bool whole = false;
};

struct KindRule {
  const char* name;
  const char* description;
  Generator generator;
  std::vector<ParameterRule> parameters;  ///< of the kind itself and, at the end, the common ones
};

[[nodiscard]] const std::vector<KindRule>& kind_rules();

[[nodiscard]] double default_value(const ParameterRule& rule, const Grid& grid);

/// The default for a person, such as "0.1 x width x spacing".
[[nodiscard]] std::string default_text(const ParameterRule& rule);

}  // namespace gnomon::terrain
