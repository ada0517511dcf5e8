// SPDX-License-Identifier: MIT
#include <nlohmann/json.hpp>

#include "trace/trace.h"

namespace gnomon::trace {
namespace {

using nlohmann::ordered_json;

ordered_json or_null(const std::optional<double>& value) {
  return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json to_json(const Step& step, bool literal) {
  return {{"step", step.number},
          {"kind", step.level > 0 ? "block"
                   : literal      ? "texel"
                                  : "patch"},
          {"level", step.level},
          {"index", {step.index.x, step.index.y}},
          {"other_side", step.other_side},
          {"t", step.t},
          {"distance", step.distance},
          {"ray", step.ray},
          {"highest", or_null(step.highest)},
          {"lowest", or_null(step.lowest)},
          {"surface", step.surface ? ordered_json(*step.surface) : ordered_json(nullptr)},
          {"decision", name_of(step.decision)},
          {"reason", step.reason}};
}

ordered_json to_json(const ViewHit& view) {
  return {{"depth", view.depth},
          {"steps", view.steps},
          {"oracle", view.oracle ? ordered_json(*view.oracle) : ordered_json(nullptr)}};
}

ordered_json to_json(const MeshView& view) {
  ordered_json document = {
      {"depth", view.depth}, {"oracle", nullptr}, {"cell", nullptr}, {"triangle", nullptr}};
  if (!view.triangle) return document;
  document["oracle"] = view.triangle->at;
  document["cell"] = {{"columns", view.triangle->columns}, {"rows", view.triangle->rows}};
  document["triangle"] = view.triangle->north_western ? "north_west" : "south_east";
  return document;
}

void add_answer(const Trace& trace, ordered_json& document) {
  const Walk& walk = *trace.walk;
  document["step_limit"] = walk.step_limit;
  document["b_shadow"] = walk.shadow != 0 ? 1 : 0;
  document["steps"] = walk.count;
  document["cause"] = cause_name(walk.cause);
  document["reason"] = cause_text(walk.cause);
  document["oracle"] = {{"horizon", trace.oracle.horizon},
                        {"b_shadow", trace.oracle.shadow ? 1 : 0},
                        {"band", trace.oracle.in_band ? 1 : 0}};
}

}  // namespace

std::string to_json(const Trace& trace, const scene::Scene& scene) {
  const technique::Ground& ground = trace.point.ground;
  ordered_json document = {{"scene", scene.id},
                           {"pixel", {trace.pixel.x, trace.pixel.y}},
                           {"image_size", {trace.point.image_size.x, trace.point.image_size.y}},
                           {"valid", trace.point.valid() ? 1 : 0},
                           {"column", ground.column[0]},
                           {"row", ground.row[0]},
                           {"q", static_cast<int>(ground.q[0])},
                           {"receiver_height", scene.shadow.receiver_height},
                           {"sun", {{"azimuth", scene.sun.azimuth}, {"elevation", scene.sun.elevation}}},
                           {"method", scene.shadow.method}};
  if (trace.point.view) document["view"] = to_json(*trace.point.view);
  if (trace.point.mesh) document["view"] = to_json(*trace.point.mesh);
  document["b_shadow"] = 0;
  document["steps"] = 0;
  if (trace.walk) add_answer(trace, document);
  document["walk"] = ordered_json::array();
  const bool literal = scene.shadow.method == "multilevel_literal";
  if (trace.walk)
    for (const Step& step : trace.walk->steps) document["walk"].push_back(to_json(step, literal));
  return document.dump(2) + "\n";
}

}  // namespace gnomon::trace
