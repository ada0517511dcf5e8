// SPDX-License-Identifier: MIT
#include "terrain/kinds.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::terrain {
namespace {

constexpr double kMaxMetres = 1e6;  ///< no terrain is higher, and sums of four stay far from float's overflow
constexpr double kMinRadius = 1e-6;
constexpr double kMaxTexels = 16384;

ParameterRule height(double factor, Measure measure, const char* description) {
  return {"height", "m", description, factor, measure, -kMaxMetres, kMaxMetres};
}
ParameterRule column(const char* description) {
  return {"column", "texel", description, 0.5, Measure::kWidthTexels, -kMaxTexels, 2 * kMaxTexels};
}
ParameterRule radius(double factor, const char* description) {
  return {"radius", "m", description, factor, Measure::kShorterSideMetres, kMinRadius, 1e9};
}
ParameterRule centre_column() {
  return {"column",
          "texel",
          "Centre, from the west edge; x + 0.5 is on sample x.",
          1,
          Measure::kMiddleColumn,
          -kMaxTexels,
          2 * kMaxTexels};
}
ParameterRule centre_row() {
  return {"row",
          "texel",
          "Centre, from the north edge; y + 0.5 is on sample y.",
          1,
          Measure::kMiddleRow,
          -kMaxTexels,
          2 * kMaxTexels};
}
ParameterRule depth(double factor, const char* description) {
  return {"depth", "m", description, factor, Measure::kShorterSideMetres, 0, kMaxMetres};
}

std::vector<KindRule> make_rules() {
  using enum Measure;
  std::vector<KindRule> rules = {
      {"flat", "A level plain.", flat, {height(0, kOne, "Height of the plain.")}},
      {"plane",
       "A tilted plane, 0 in the south-west corner of the map.",
       plane,
       {{"slope_x", "1", "Rise per metre towards the east.", 0.25, kOne, -1000, 1000},
        {"slope_y", "1", "Rise per metre towards the north.", 0, kOne, -1000, 1000}}},
      {"wall",
       "A wall from north to south on level ground.",
       wall,
       {height(20, kOne, "Height of the wall."),
        column("West face, from the west edge; the wall begins with the first sample beyond it."),
        {"thickness", "texel", "Extent from west to east.", 1, kOne, 0, kMaxTexels}}},
      {"step",
       "High ground in the west that ends in a straight edge from north to south.",
       step,
       {height(20, kOne, "Height of the ground west of the edge."),
        column("The edge, from the west edge of the map; samples west of it are high.")}},
      {"steps",
       "A staircase that descends from west to east.",
       steps,
       {{"count", "1", "Number of rises; there is one tread more.", 8, kOne, 1, kMaxTexels, true},
        {"rise", "m", "Height of one rise.", 5, kOne, -kMaxMetres / kMaxTexels, kMaxMetres / kMaxTexels}}},
      {"cone",
       "A cone on level ground.",
       cone,
       {height(0.15, kShorterSideMetres, "Height of the tip."), radius(0.2, "Radius of the foot."),
        centre_column(), centre_row()}},
      {"spikes",
       "Five thin, tall cones: the stress map of Timokhin and Mikhaylyuk 2021. The seed moves them.",
       spikes,
       {height(0.3, kShorterSideMetres, "Height of the tips."), radius(0.025, "Radius of the feet.")}},
      {"posts",
       "Posts of one sample each, one in every square; the seed places them.",
       posts,
       {height(10, kOne, "Height of the posts."),
        {"pitch", "texel", "Side of the squares.", 16, kOne, 1, kMaxTexels, true}}},
      {"crater",
       "A paraboloid bowl, height = depth * (r^2 / radius^2 - 1) inside the radius, in level ground.",
       crater,
       {depth(0.1, "Depth of the lowest point."), radius(0.35, "Radius of the rim."), centre_column(),
        centre_row()}},
      {"gorge",
       "A plateau with a branching, meandering canyon whose walls are terraced.",
       gorge,
       {depth(0.08, "Depth of the canyon below the plateau."),
        {"terraces", "1", "Number of cliffs between rim and river.", 5, kOne, 1, 64, true}}},
      {"checker",
       "Squares, high and low in turn.",
       checker,
       {height(10, kOne, "Height of the high squares; the one in the north-west is high."),
        {"cell", "texel", "Side of the squares.", 16, kOne, 1, kMaxTexels, true}}},
      {"fractal",
       "Mountains: ridged fractional Brownian motion.",
       fractal,
       {{"relief", "m", "Height of the highest sample above the lowest, which is 0.", 0.1, kWidthMetres, 0,
         kMaxMetres},
        {"cells", "1", "Noise cells across the map in the first octave.", 4, kOne, 1, 64},
        {"octaves", "1", "Number of octaves.", 8, kOne, 1, 16, true},
        {"gain", "1", "Amplitude of an octave relative to the one before.", 0.5, kOne, 0, 1},
        {"lacunarity", "1", "Frequency of an octave relative to the one before.", 2, kOne, 1, 4}}},
  };
  for (KindRule& rule : rules) {
    rule.parameters.push_back({"mirror", "1", "1: the map is mirrored west to east.", 0, kOne, 0, 1, true});
    rule.parameters.push_back(
        {"quarter_turns", "1", "Clockwise turns by 90 degrees, after mirroring.", 0, kOne, 0, 3, true});
  }
  return rules;
}

}  // namespace

const std::vector<KindRule>& kind_rules() {
  static const std::vector<KindRule> rules = make_rules();
  return rules;
}

double default_value(const ParameterRule& rule, const Grid& grid) {
  switch (rule.measure) {
    case Measure::kOne:
      return rule.factor;
    case Measure::kWidthMetres:
      return rule.factor * grid.width_metres();
    case Measure::kShorterSideMetres:
      return rule.factor * std::min(grid.width_metres(), grid.height_metres());
    case Measure::kWidthTexels:
      return rule.factor * grid.width;
    case Measure::kMiddleColumn:
      return rule.factor * (grid.width / 2 + 0.5);
    case Measure::kMiddleRow:
      return rule.factor * (grid.height / 2 + 0.5);
  }
  return rule.factor;
}

std::string default_text(const ParameterRule& rule) {
  switch (rule.measure) {
    case Measure::kOne:
      break;
    case Measure::kWidthMetres:
      return fmt::format("{} x width x spacing", rule.factor);
    case Measure::kShorterSideMetres:
      return fmt::format("{} x the map's shorter side", rule.factor);
    case Measure::kWidthTexels:
      return fmt::format("{} x width", rule.factor);
    case Measure::kMiddleColumn:
      return "the middle sample, floor(width / 2) + 0.5";
    case Measure::kMiddleRow:
      return "the middle sample, floor(height / 2) + 0.5";
  }
  return fmt::format("{}", rule.factor);
}

}  // namespace gnomon::terrain
