// SPDX-License-Identifier: MIT
#include "cli/commands.h"
#include "technique/technique.h"
#include "terrain/load.h"
#include "terrain/map_place.h"
#include "terrain/procedural.h"

namespace gnomon::cli {

scene::Vocabulary vocabulary() {
  scene::Vocabulary words;
  for (const technique::Technique& technique : technique::techniques())
    words.methods.push_back(technique.name);
  for (const terrain::ProceduralKind& kind : terrain::procedural_kinds()) {
    std::vector<std::string>& names = words.kinds[kind.name];
    for (const terrain::ProceduralParameter& parameter : kind.parameters) names.push_back(parameter.name);
  }
  words.file_size = [](const scene::FileTerrain& file) -> std::optional<std::array<int, 2>> {
    // Where it cannot be read, that is said with its reason when the map is loaded.
    return terrain::height_map_size(file.path, {.channel = file.channel, .raw = file.raw});
  };
  words.map_centre = [](const scene::FileTerrain& file) -> std::optional<scene::MapCentre> {
    const auto place = terrain::height_map_place(file.path, {.channel = file.channel, .raw = file.raw});
    if (!place) return std::nullopt;
    return scene::MapCentre{{place->latitude, place->longitude}, place->convergence};
  };
  words.channels = {"b_shadow", "k_shadow", "q",        "steps", "valid", "horizon", "column",
                    "row",      "depth",    "coverage", "R",     "G",     "B"};
  return words;
}

}  // namespace gnomon::cli
