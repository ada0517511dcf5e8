// SPDX-License-Identifier: MIT
#include "scene/values.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "scene/suggest.h"

namespace gnomon::scene {

int integer_of(const json::Value& value) {
  const std::int64_t wide = std::get<std::int64_t>(value.data);
  constexpr std::int64_t kMost = std::numeric_limits<int>::max();
  return static_cast<int>(
      std::clamp(wide, -kMost, kMost));  // the schema's ranges are narrower, or checked later
}

std::array<int, 2> integer_pair_of(const json::Value& value) {
  return {integer_of(value.array()[0]), integer_of(value.array()[1])};
}

void read_number(const json::Value& object, const char* key, double& number) {
  if (const json::Value* value = object.find(key)) number = value->number();
}

void read_integer(const json::Value& object, const char* key, int& number) {
  if (const json::Value* value = object.find(key)) number = integer_of(*value);
}

void check_name(const std::string& noun, const std::string& name, const std::vector<std::string>& known,
                json::Place place, const std::string& pointer, Report& report) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  report.error(place, pointer, unknown_name(noun, name, known));
}

double compass(double degrees) {
  const double turned = std::fmod(degrees, 360.0);
  const double positive = turned < 0 ? turned + 360.0 : turned;
  return positive < 360.0 ? positive : 0.0;
}

InsideFile inside_file(const json::Value& name, const std::string& pointer, const BuildContext& context,
                       Report& report) {
  const std::string folder = std::filesystem::path(context.file).parent_path().generic_string();
  const Result<InsideFile> inside = resolve_inside(context.project, folder, name.text());
  if (inside) return *inside;
  report.error(name.place, pointer, inside.diagnostics().front().message);
  return {};
}

}  // namespace gnomon::scene
