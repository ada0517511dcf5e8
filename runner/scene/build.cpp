// SPDX-License-Identifier: MIT
#include "scene/build.h"

#include <algorithm>
#include <cmath>

#include "scene/build_camera.h"
#include "scene/build_ground.h"
#include "scene/build_shadow.h"
#include "scene/build_sun.h"
#include "scene/suggest.h"
#include "scene/values.h"
#include "terrain/height_map.h"

namespace gnomon::scene {
namespace {

using json::child;
using json::Value;

void check_channel(const json::Member& member, const std::string& pointer, const Vocabulary& vocabulary,
                   Report& report) {
  if (vocabulary.channels.empty()) return;
  check_name("channel", member.key, vocabulary.channels, member.place, child(pointer, member.key), report);
}

InlineTerrain read_heights(const Value& heights, double vertical_scale, Report& report) {
  const std::string pointer = "/terrain/heights";
  const json::Array& rows = heights.array();
  InlineTerrain terrain{static_cast<int>(rows[0].array().size()), static_cast<int>(rows.size()), {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const json::Array& row = rows[i].array();
    if (row.size() != rows[0].array().size()) {
      report.error(rows[i].place, child(pointer, i),
                   "this row has " + std::to_string(row.size()) + " heights, the first one " +
                       std::to_string(terrain.width) + "; expected rows of equal length");
    }
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (!row[j].is_number()) {
        terrain.heights.push_back(InlineTerrain::kNull);
        continue;
      }
      terrain.heights.push_back(row[j].number());
      if (std::abs(row[j].number() * vertical_scale) <= terrain::kHighestHeight) continue;
      report.error(row[j].place, child(child(pointer, i), j),
                   "the height is too large for single precision; expected at most 1e15 m");
    }
  }
  return terrain;
}

/// The schema has settled the names and ranges.
terrain::RawLayout read_raw(const Value& raw) {
  const std::array<int, 2> size = integer_pair_of(*raw.find("size"));
  terrain::RawLayout layout{size[0], size[1], terrain::raw_type(raw.find("type")->text()).value()};
  if (const Value* order = raw.find("byte_order")) layout.big_endian = order->text() == "big";
  if (const Value* skip = raw.find("skip"))
    layout.skip = static_cast<std::uint64_t>(std::get<std::int64_t>(skip->data));
  return layout;
}

FileTerrain read_file(const Value& terrain, const BuildContext& context, std::string& below_root,
                      Report& report) {
  const InsideFile inside = inside_file(*terrain.find("file"), "/terrain/file", context, report);
  below_root = inside.below_root;
  FileTerrain result{.path = inside.path};
  if (const Value* channel = terrain.find("channel")) result.channel = channel->text();
  if (const Value* raw = terrain.find("raw")) result.raw = read_raw(*raw);
  if (const Value* nodata = terrain.find("nodata")) result.nodata = nodata->number();
  return result;
}

ProceduralTerrain read_procedural(const Value& terrain, const Vocabulary& vocabulary, Report& report) {
  ProceduralTerrain result;
  const Value& kind = *terrain.find("procedural");
  result.kind = kind.text();
  std::vector<std::string> kinds;
  for (const auto& [name, parameters] : vocabulary.kinds) kinds.push_back(name);
  check_name("kind of procedural map", result.kind, kinds, kind.place, "/terrain/procedural", report);
  if (const Value* size = terrain.find("size")) {
    result.width = integer_pair_of(*size)[0];
    result.height = integer_pair_of(*size)[1];
  }
  if (const Value* seed = terrain.find("seed")) {
    result.seed = static_cast<std::uint32_t>(std::get<std::int64_t>(seed->data));
  }
  const auto known = vocabulary.kinds.find(result.kind);
  const Value* parameters = terrain.find("parameters");
  if (!parameters || known == vocabulary.kinds.end()) return result;
  for (const json::Member& parameter : parameters->object()) {
    check_name("parameter of " + result.kind, parameter.key, known->second, parameter.place,
               child("/terrain/parameters", parameter.key), report);
    result.parameters[parameter.key] = parameter.value.number();
  }
  return result;
}

Terrain read_terrain(const Value& value, const BuildContext& context, std::string& below_root,
                     Report& report) {
  Terrain terrain;
  if (const Value* scale = value.find("vertical_scale")) terrain.vertical_scale = scale->number();
  if (const Value* spacing = value.find("spacing")) {
    const json::Array* pair = spacing->get_if<json::Array>();
    terrain.spacing = pair ? std::array{(*pair)[0].number(), (*pair)[1].number()}
                           : std::array{spacing->number(), spacing->number()};
  }
  if (const Value* heights = value.find("heights")) {
    terrain.source = read_heights(*heights, terrain.vertical_scale.value_or(1.0), report);
  } else if (value.find("file")) {
    terrain.source = read_file(value, context, below_root, report);
  } else {
    terrain.source = read_procedural(value, context.vocabulary, report);
  }
  return terrain;
}

Expectation read_golden(const Value& value, const std::string& pointer, const Vocabulary& vocabulary,
                        Report& report) {
  GoldenExpectation golden;
  read_number(value, "max_mismatch", golden.max_mismatch);
  if (const Value* band = value.find("band")) golden.band = std::get<bool>(band->data);
  if (const Value* unproven = value.find("unproven")) golden.unproven = unproven->text();
  if (const Value* tolerance = value.find("tolerance")) {
    for (const json::Member& member : tolerance->object()) {
      check_channel(member, child(pointer, "tolerance"), vocabulary, report);
      golden.tolerance[member.key] = member.value.number();
    }
  }
  return golden;
}

Expectation read_reference(const Value& value, const std::string& pointer, Report& report) {
  ReferenceExpectation reference;
  read_number(value, "max_mismatch", reference.max_mismatch);
  if (const Value* level = value.find("level")) reference.level = integer_of(*level);
  if (const Value* mismatch = value.find("mismatch")) {
    reference.mismatch = {mismatch->array()[0].number(), mismatch->array()[1].number()};
    if ((*reference.mismatch)[0] > (*reference.mismatch)[1]) {
      report.error(mismatch->place, child(pointer, "mismatch"),
                   "expected [least, greatest], got " + dump(*mismatch));
    }
    if (value.find("max_mismatch")) {
      report.error(mismatch->place, child(pointer, "mismatch"),
                   "\"mismatch\" does not go together with \"max_mismatch\": give one or the other");
    }
  }
  return reference;
}

Expectation read_probe(const Value& value, const std::string& pointer, const Vocabulary& vocabulary,
                       Report& report) {
  const std::array<int, 2> at = integer_pair_of(*value.find("at"));
  ProbeExpectation probe{at[0], at[1], {}};
  for (const json::Member& member : value.object()) {
    if (member.key == "at") continue;
    check_channel(member, pointer, vocabulary, report);
    probe.values[member.key] = member.value.number();
  }
  return probe;
}

Expectation read_expectation(const Value& value, const std::string& pointer, const Vocabulary& vocabulary,
                             Report& report) {
  const json::Member& only = value.object().front();
  const std::string inner = child(pointer, only.key);
  if (only.key == "golden") return read_golden(only.value, inner, vocabulary, report);
  if (only.key == "reference") return read_reference(only.value, inner, report);
  if (only.key == "probe") return read_probe(only.value, inner, vocabulary, report);
  return MaxStepsExpectation{only.value.number()};
}

/// What determines the image, with every default filled in, so that a scene hash changes if and only if that
/// does.
std::string canonical_json(const Scene& scene, const std::string& file_below_root) {
  const auto object = [](std::initializer_list<std::pair<const char*, Value>> members) {
    Value result{json::Object{}};
    for (const auto& [key, value] : members) result.set(key, value);
    return result;
  };
  const auto pair = [](auto values) { return Value{json::Array{Value{values[0]}, Value{values[1]}}}; };
  const auto size = [&](int width, int height) { return pair(std::array<std::int64_t, 2>{width, height}); };
  Value terrain{json::Object{}};
  if (const auto* file = std::get_if<FileTerrain>(&scene.terrain.source)) {
    terrain.set("file", {file_below_root});
    if (file->channel) terrain.set("channel", {*file->channel});
    if (file->nodata) terrain.set("nodata", {*file->nodata});
    if (file->raw)
      terrain.set("raw", object({{"size", size(file->raw->width, file->raw->height)},
                                 {"type", {std::string(gnomon::terrain::name_of(file->raw->type))}},
                                 {"byte_order", {std::string(file->raw->big_endian ? "big" : "little")}},
                                 {"skip", {static_cast<std::int64_t>(file->raw->skip)}}}));
  } else if (const auto* heights = std::get_if<InlineTerrain>(&scene.terrain.source)) {
    json::Array values;
    for (const double height : heights->heights)
      values.push_back(height == InlineTerrain::kNull ? Value{nullptr} : Value{height});
    terrain = object({{"size", size(heights->width, heights->height)}, {"heights", {std::move(values)}}});
  } else {
    const auto& procedural = std::get<ProceduralTerrain>(scene.terrain.source);
    Value parameters{json::Object{}};
    for (const auto& [name, value] : procedural.parameters) parameters.set(name, {value});
    terrain = object({{"procedural", {procedural.kind}},
                      {"size", size(procedural.width, procedural.height)},
                      {"seed", {static_cast<std::int64_t>(procedural.seed)}},
                      {"parameters", parameters}});
  }
  const bool has_default = !terrain.find("file");  // a file may bring its own spacing and unit
  if (scene.terrain.spacing || has_default)
    terrain.set("spacing", pair(scene.terrain.spacing.value_or(std::array{1.0, 1.0})));
  if (scene.terrain.vertical_scale || has_default)
    terrain.set("vertical_scale", {scene.terrain.vertical_scale.value_or(1.0)});
  Value canonical = object({{"terrain", terrain},
                            {"sun", canonical_sun(scene.sun)},
                            {"camera", canonical_camera(scene.camera)},
                            {"shadow", canonical_shadow(scene.shadow)}});
  // The map camera shows no ground: the section does not determine its image.
  if (!std::get_if<MapCamera>(&scene.camera)) canonical.set("ground", canonical_ground(scene.ground));
  return dump(canonical);
}

}  // namespace

Scene build_scene(const Value& root, const BuildContext& context, Report& report) {
  Scene scene;
  std::string file_below_root;
  scene.file = context.file;
  if (const Value* description = root.find("description")) scene.description = description->text();
  if (const Value* terrain = root.find("terrain")) {
    scene.terrain = read_terrain(*terrain, context, file_below_root, report);
  }
  const Value* written_sun = root.find("sun");
  const bool by_time = written_sun && written_sun->find("time");
  SunOnMap sun =
      read_sun(written_sun, by_time ? map_centre(scene.terrain, context.vocabulary) : std::nullopt, report);
  scene.sun = sun.sun;
  if (!sun.note.empty()) scene.notes.push_back(std::move(sun.note));
  scene.camera = read_camera(root.find("camera"), context, report);
  scene.shadow = read_shadow(root.find("shadow"), context.vocabulary, report);
  scene.ground = read_ground(root.find("ground"), context, report);
  const Value* expect = root.find("expect");
  const bool is_list = expect && expect->get_if<json::Array>();  // else reported with the shape
  for (std::size_t i = 0; is_list && i < expect->array().size(); ++i) {
    scene.expect.push_back(
        read_expectation(expect->array()[i], child("/expect", i), context.vocabulary, report));
  }
  scene.canonical_json = canonical_json(scene, file_below_root);
  return scene;
}

std::vector<SizeProblem> size_problems(const Scene& scene, std::array<int, 2> map_size) {
  std::vector<SizeProblem> problems;
  const auto text = [](std::array<int, 2> size) {
    return std::to_string(size[0]) + "x" + std::to_string(size[1]);
  };
  int coarsest = 0;
  while ((std::int64_t{1} << coarsest) < std::max(map_size[0], map_size[1])) ++coarsest;
  const auto check_level = [&](int level, const std::string& pointer) {
    if (level <= coarsest) return;
    problems.push_back({pointer, "level " + std::to_string(level) +
                                     " does not exist; the coarsest level of a " + text(map_size) +
                                     " map is L = " + std::to_string(coarsest)});
  };
  if (scene.shadow.q) check_level(*scene.shadow.q, "/shadow/q");
  const std::optional<std::array<int, 2>> image = image_size(scene.camera, map_size);
  for (std::size_t i = 0; i < scene.expect.size(); ++i) {
    const std::string pointer = child("/expect", i);
    if (const auto* reference = std::get_if<ReferenceExpectation>(&scene.expect[i]);
        reference && reference->level) {
      check_level(*reference->level, pointer + "/reference/level");
    }
    const auto* probe = std::get_if<ProbeExpectation>(&scene.expect[i]);
    if (!probe || !image || (probe->x < (*image)[0] && probe->y < (*image)[1])) continue;
    problems.push_back({pointer + "/probe/at", "the pixel [" + std::to_string(probe->x) + ", " +
                                                   std::to_string(probe->y) + "] lies outside the " +
                                                   text(*image) + " image (counted from 0)"});
  }
  return problems;
}

std::optional<std::array<int, 2>> map_size(const Scene& scene, const Vocabulary& vocabulary) {
  if (const auto* heights = std::get_if<InlineTerrain>(&scene.terrain.source)) {
    return std::array{heights->width, heights->height};
  }
  if (const auto* procedural = std::get_if<ProceduralTerrain>(&scene.terrain.source)) {
    return std::array{procedural->width, procedural->height};
  }
  const auto& file = std::get<FileTerrain>(scene.terrain.source);
  return vocabulary.file_size && !file.path.empty() ? vocabulary.file_size(file) : std::nullopt;
}

}  // namespace gnomon::scene
