// SPDX-License-Identifier: MIT
#include "cli/commands.h"
#include "image/stored_image.h"
#include "technique/technique.h"
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
    const auto image =
        image::read_stored(file.path, {.one_channel = true, .channel = file.channel, .header_only = true});
    if (!image) return std::nullopt;  // said with its reason when the map is loaded
    return std::array{image->width, image->height};
  };
  words.channels = {"b_shadow", "k_shadow", "q",        "steps", "valid", "horizon", "column",
                    "row",      "depth",    "coverage", "R",     "G",     "B"};
  return words;
}

}  // namespace gnomon::cli
