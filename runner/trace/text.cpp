// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "trace/trace.h"

namespace gnomon::trace {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;

std::string row(const std::string& name, const std::string& value) {
  return fmt::format("{:<8} {}\n", name, value);
}

std::string asked_at(const Trace& trace, const scene::Scene& scene) {
  const technique::Ground& ground = trace.point.ground;
  const std::string where = scene.shadow.receiver_height > 0
                                ? fmt::format("{:.10g} m above", scene.shadow.receiver_height)
                                : std::string("on");
  return row("asks",
             fmt::format("column {:.9g}, row {:.9g} (texels of the map from its west and north edge), "
                         "{} the surface at q {}",
                         ground.column[0], ground.row[0], where, ground.q[0]));
}

/// How the oracle's view ray agrees with the modules'.
std::string beside_oracle(const ViewHit& view, const technique::Ground& ground, bool valid) {
  if (!view.oracle) return valid ? "; the oracle's ray sees nothing here" : "";
  if (!valid)
    return fmt::format("; the oracle's ray sees column {:.9g}, row {:.9g}", (*view.oracle)[0],
                       (*view.oracle)[1]);
  const double apart =
      std::hypot((*view.oracle)[0] - double{ground.column[0]}, (*view.oracle)[1] - double{ground.row[0]});
  return fmt::format("; the oracle's ray sees column {:.9g}, row {:.9g}, {:.3g} texels beside it",
                     (*view.oracle)[0], (*view.oracle)[1], apart);
}

std::string seen_of_mesh(const MeshView& view) {
  if (!view.triangle) return row("view", "the view ray meets no triangle of the mesh");
  const Triangle& triangle = *view.triangle;
  return row("view",
             fmt::format("the view ray meets the mesh after {:.7g} m at column {:.9g}, row {:.9g}, in the "
                         "{} triangle of the cell from column {:g} to {:g}, row {:g} to {:g}; in double "
                         "precision, beside which a GPU may round",
                         view.depth, triangle.at[0], triangle.at[1],
                         triangle.north_western ? "north-western" : "south-eastern", triangle.columns[0],
                         triangle.columns[1], triangle.rows[0], triangle.rows[1]));
}

std::string seen(const Trace& trace) {
  if (trace.point.mesh) return seen_of_mesh(*trace.point.mesh);
  if (!trace.point.view) return {};
  const ViewHit& view = *trace.point.view;
  const bool valid = trace.point.valid();
  const std::string hit = valid ? fmt::format("the view ray meets the surface after {:.7g} m and {} steps",
                                              view.depth, view.steps)
                                : fmt::format("the view ray meets no surface, in {} steps", view.steps);
  return row("view", hit + beside_oracle(view, trace.point.ground, valid));
}

std::string header(const Trace& trace, const scene::Scene& scene) {
  std::string text = fmt::format("{}: pixel ({}, {}) of {} x {}\n", scene.id, trace.pixel.x, trace.pixel.y,
                                 trace.point.image_size.x, trace.point.image_size.y);
  text += seen(trace);
  if (trace.point.valid()) text += asked_at(trace, scene);
  text += row("sun", fmt::format("azimuth {:.10g}, elevation {:.10g} degrees", scene.sun.azimuth,
                                 scene.sun.elevation));
  text += row("method", scene.shadow.method +
                            (trace.walk ? fmt::format(", at most {} steps", trace.walk->step_limit) : ""));
  if (trace.walk && !trace.walk->steps.empty())
    text += row("ray", fmt::format("starts at {:.7g} m and rises {:.6g} m a metre on the ground",
                                   trace.walk->height, std::tan(scene.sun.elevation / kDegrees)));
  return text;
}

std::string what(const Step& step, bool literal) {
  const std::string index = fmt::format("{},{}", step.index.x, step.index.y);
  const std::string kind = step.level > 0 ? fmt::format("{} block", step.level)
                           : literal      ? "- texel"
                                          : "0 patch";
  return kind + " " + index + (step.other_side ? " (other side)" : "");
}

/// Metres or texels; without the sign of a zero.
std::string number(double value) {
  return fmt::format("{:.3f}", std::abs(value) < 0.0005 ? 0.0 : value);
}

std::string span(const Span& values) {
  return number(values[0]) + " .. " + number(values[1]);
}

std::string bound(const Step& step) {
  if (step.surface) return span(*step.surface);
  if (step.lowest) return "min " + number(*step.lowest) + " max " + number(*step.highest);
  if (step.highest) return "max " + number(*step.highest);
  return "none";
}

using Cells = std::vector<std::string>;

Cells cells(const Step& step, bool literal) {
  return {std::to_string(step.number),
          what(step, literal),
          span(step.t),
          span(step.distance),
          span(step.ray),
          bound(step),
          step.reason};
}

/// Columns as wide as their widest cell.
std::string table(const std::vector<Cells>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Cells& row : rows)
    for (std::size_t i = 0; i + 1 < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  std::string text;
  for (const Cells& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      text += i == 0 ? fmt::format("{:>{}}", row[i], widths[i]) : fmt::format("  {:<{}}", row[i], widths[i]);
    text += "  " + row.back() + "\n";
  }
  return text;
}

std::string oracle_text(const Trace& trace, const scene::Scene& scene) {
  const OracleAnswer& oracle = trace.oracle;
  const std::string horizon = oracle.horizon <= -1.57
                                  ? "nothing ahead"
                                  : fmt::format("the horizon {:.6f} degrees high", oracle.horizon * kDegrees);
  const bool agrees = oracle.shadow == (trace.walk->shadow != 0);
  return fmt::format("Oracle: {}, {}, the sun {:.6f}: {}; the pixel is {} the band",
                     oracle.shadow ? "in shadow" : "lit", horizon, scene.sun.elevation,
                     agrees ? "they agree" : "they DIFFER", oracle.in_band ? "in" : "outside of");
}

std::string verdict(const Trace& trace, const scene::Scene& scene) {
  if (!trace.walk)
    return "verdict: nothing is asked, as there is no surface here (valid 0): b_shadow 0, steps 0\n";
  const Walk& walk = *trace.walk;
  const char* answer = !walk.decided() ? "UNDECIDED" : walk.shadow != 0 ? "in shadow" : "lit";
  return fmt::format("verdict: {} (b_shadow {}, steps {}): {}. {}\n", answer, walk.shadow, walk.count,
                     cause_text(walk.cause), oracle_text(trace, scene));
}

}  // namespace

std::string to_text(const Trace& trace, const scene::Scene& scene) {
  std::string text = header(trace, scene);
  if (trace.walk && !trace.walk->steps.empty()) {
    const bool literal = scene.shadow.method == "multilevel_literal";
    std::vector<Cells> rows{{"step", "level, place", literal ? "t (texels)" : "t", "distance (m)", "ray (m)",
                             "bound or surface (m)", "decision and reason"}};
    for (const Step& step : trace.walk->steps) rows.push_back(cells(step, literal));
    text += "\n" + table(rows) + "\n";
  }
  return text + verdict(trace, scene);
}

}  // namespace gnomon::trace
