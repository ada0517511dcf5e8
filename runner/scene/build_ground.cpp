// SPDX-License-Identifier: MIT
#include "scene/build_ground.h"

#include "scene/values.h"

namespace gnomon::scene {
namespace {

using json::Value;

Colour colour_of(const Value& value) {
  return {value.array()[0].number(), value.array()[1].number(), value.array()[2].number()};
}

HeightAlbedo read_heights(const Value& heights, Report& report) {
  HeightAlbedo albedo;
  for (std::size_t i = 0; i < heights.array().size(); ++i) {
    const Value& entry = heights.array()[i];
    const double height = entry.find("height")->number();
    if (!albedo.colours.empty() && height <= albedo.colours.back().first) {
      report.error(entry.place, json::child(json::child("/ground/albedo/heights", i), "height"),
                   "expected heights that rise from entry to entry");
    }
    albedo.colours.emplace_back(height, colour_of(*entry.find("colour")));
  }
  return albedo;
}

struct CanonicalAlbedo {
  Value operator()(const ConstantAlbedo& albedo) const { return list_of(albedo.colour); }
  Value operator()(const ImageAlbedo& albedo) const {
    Value file{json::Object{}};
    file.set("file", {albedo.below_root});
    return file;
  }
  Value operator()(const HeightAlbedo& albedo) const {
    json::Array entries;
    for (const auto& [height, colour] : albedo.colours) {
      Value entry{json::Object{}};
      entry.set("height", {height});
      entry.set("colour", list_of(colour));
      entries.push_back(std::move(entry));
    }
    Value heights{json::Object{}};
    heights.set("heights", {std::move(entries)});
    return heights;
  }
};

}  // namespace

Ground read_ground(const Value* value, const BuildContext& context, Report& report) {
  Ground ground;
  if (!value) return ground;
  if (const Value* ambient = value->find("ambient")) ground.ambient = ambient->number();
  const Value* albedo = value->find("albedo");
  if (!albedo) return ground;
  if (const Value* file = albedo->find("file")) {
    const InsideFile inside = inside_file(*file, "/ground/albedo/file", context, report);
    ground.albedo = ImageAlbedo{inside.path, inside.below_root};
  } else if (const Value* heights = albedo->find("heights")) {
    ground.albedo = read_heights(*heights, report);
  } else {
    ground.albedo = ConstantAlbedo{colour_of(*albedo)};
  }
  return ground;
}

Value canonical_ground(const Ground& ground) {
  Value value{json::Object{}};
  value.set("albedo", std::visit(CanonicalAlbedo{}, ground.albedo));
  value.set("ambient", {ground.ambient});
  return value;
}

}  // namespace gnomon::scene
