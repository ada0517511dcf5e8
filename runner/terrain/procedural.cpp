// SPDX-License-Identifier: MIT
#include "terrain/procedural.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "terrain/kinds.h"

namespace gnomon::terrain {
namespace {

Diagnostic invalid(std::string message) {
  return {.message = std::move(message)};
}

template <class Rules>
std::string names(const Rules& rules) {
  std::vector<std::string> all;
  for (const auto& rule : rules) all.emplace_back(rule.name);
  return fmt::format("{}", fmt::join(all, ", "));
}

const KindRule* find_kind(const std::string& name) {
  const auto& rules = kind_rules();
  const auto found =
      std::find_if(rules.begin(), rules.end(), [&](const KindRule& rule) { return rule.name == name; });
  return found == rules.end() ? nullptr : &*found;
}

Diagnostics check_grid(const ProceduralRequest& request) {
  Diagnostics errors;
  for (const auto& [what, size] : {std::pair{"width", request.width}, std::pair{"height", request.height}})
    if (size < 1 || size > kLargestProceduralSize)
      errors.push_back(invalid(fmt::format("a procedural map's {} must be 1 to {} samples, not {}", what,
                                           kLargestProceduralSize, size)));
  for (const double spacing : {request.spacing_x, request.spacing_y})
    if (!(spacing >= 1e-6 && spacing <= 1e6))
      errors.push_back(invalid(fmt::format("the spacing must be 1e-6 to 1e6 metres, not {}", spacing)));
  if (!std::isfinite(request.vertical_scale))
    errors.push_back(
        invalid(fmt::format("the vertical scale must be a finite number, not {}", request.vertical_scale)));
  return errors;
}

Diagnostics check_parameters(const ProceduralRequest& request, const KindRule& kind) {
  Diagnostics errors;
  for (const auto& [name, value] : request.parameters) {
    const auto rule = std::find_if(kind.parameters.begin(), kind.parameters.end(),
                                   [&, &key = name](const ParameterRule& r) { return r.name == key; });
    if (rule == kind.parameters.end()) {
      errors.push_back(invalid(fmt::format("procedural '{}' has no parameter '{}'; it has {}", kind.name,
                                           name, names(kind.parameters))));
      continue;
    }
    const bool in_range = value >= rule->minimum && value <= rule->maximum;
    const bool whole = !rule->whole || std::floor(value) == value;
    if (!in_range || !whole)
      errors.push_back(invalid(fmt::format(
          "parameter '{}' of procedural '{}' must be a {} from {} to {} ({}), not {}", name, kind.name,
          rule->whole ? "whole number" : "number", rule->minimum, rule->maximum, rule->unit, value)));
  }
  return errors;
}

/// How a finished map is turned: mirrored west to east first, then by quarter turns clockwise.
struct Orientation {
  bool mirror = false;
  int quarter_turns = 0;

  [[nodiscard]] bool swaps_axes() const { return quarter_turns % 2 == 1; }
};

/// The grid that the generator fills, so that turning it gives the requested one.
Grid grid_before_turning(const ProceduralRequest& request, const Orientation& orientation) {
  Grid grid{request.width, request.height, request.spacing_x, request.spacing_y, request.seed};
  if (orientation.swaps_axes()) {
    std::swap(grid.width, grid.height);
    std::swap(grid.spacing_x, grid.spacing_y);
  }
  return grid;
}

/// Where sample (row, column) of the turned map lies in the map before turning, row-major.
std::size_t index_before_turning(const Grid& before, const Orientation& orientation, int row, int column) {
  int source_row = row;
  int source_column = column;
  switch (orientation.quarter_turns) {
    case 1:
      source_row = before.height - 1 - column, source_column = row;
      break;
    case 2:
      source_row = before.height - 1 - row, source_column = before.width - 1 - column;
      break;
    case 3:
      source_row = column, source_column = before.width - 1 - row;
      break;
    default:
      break;
  }
  if (orientation.mirror) source_column = before.width - 1 - source_column;
  return static_cast<std::size_t>(source_row) * static_cast<std::size_t>(before.width) +
         static_cast<std::size_t>(source_column);
}

HeightMap empty_map(const ProceduralRequest& request) {
  HeightMap map;
  map.width = request.width;
  map.height = request.height;
  map.spacing_x = request.spacing_x;
  map.spacing_y = request.spacing_y;
  map.domain_width = request.width;
  map.domain_height = request.height;
  map.samples.reserve(static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height));
  return map;
}

}  // namespace

const std::vector<ProceduralKind>& procedural_kinds() {
  static const std::vector<ProceduralKind> kinds = [] {
    std::vector<ProceduralKind> made;
    for (const KindRule& rule : kind_rules()) {
      ProceduralKind kind{rule.name, rule.description, {}};
      for (const ParameterRule& p : rule.parameters)
        kind.parameters.push_back(
            {p.name, p.unit, p.description, default_text(p), p.minimum, p.maximum, p.whole});
      made.push_back(std::move(kind));
    }
    return made;
  }();
  return kinds;
}

Result<HeightMap> make_procedural(const ProceduralRequest& request) {
  const KindRule* kind = find_kind(request.kind);
  if (kind == nullptr)
    return invalid(
        fmt::format("there is no procedural map '{}'; there are {}", request.kind, names(kind_rules())));
  Diagnostics errors = check_grid(request);
  for (Diagnostic& error : check_parameters(request, *kind)) errors.push_back(std::move(error));
  if (!errors.empty()) return errors;

  const auto given = [&](const char* name) {
    const auto found = request.parameters.find(name);
    return found == request.parameters.end() ? 0 : static_cast<int>(found->second);
  };
  const Orientation orientation{given("mirror") == 1, given("quarter_turns")};
  const Grid grid = grid_before_turning(request, orientation);
  Parameters parameters = request.parameters;
  for (const ParameterRule& rule : kind->parameters)
    parameters.try_emplace(rule.name, default_value(rule, grid));
  const Heights heights = kind->generator(grid, parameters);

  HeightMap map = empty_map(request);
  for (int row = 0; row < map.height; ++row)
    for (int column = 0; column < map.width; ++column) {
      const double metres =
          heights[index_before_turning(grid, orientation, row, column)] * request.vertical_scale;
      if (std::abs(metres) > kHighestHeight)
        return invalid(
            fmt::format("procedural '{}' times the vertical scale {} is too high for single precision",
                        kind->name, request.vertical_scale));
      map.samples.push_back(static_cast<float>(metres));
    }
  return map;
}

}  // namespace gnomon::terrain
