// SPDX-License-Identifier: MIT
#include "scene/build_sun.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/values.h"

namespace gnomon::scene {
namespace {

using json::Value;

Sun sun_towards(const Value& direction, Report& report) {
  const Result<std::array<double, 3>> towards = direction_of(direction);
  if (!towards) {
    report.error(direction.place, "/sun/direction", towards.diagnostics().front().message);
    return {};
  }
  const std::array<double, 3>& v = *towards;
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  return {compass(std::atan2(v[0], v[1]) * kDegrees), std::atan2(v[2], std::hypot(v[0], v[1])) * kDegrees};
}

std::optional<ephemeris::Place> read_place(const Value& sun, Report& report) {
  const Value *latitude = sun.find("latitude"), *longitude = sun.find("longitude");
  if (latitude && longitude) return ephemeris::Place{latitude->number(), longitude->number()};
  for (const auto& [there, key, other] :
       {std::tuple{latitude, "latitude", "longitude"}, std::tuple{longitude, "longitude", "latitude"}}) {
    if (!there) continue;
    report.error(there->place, json::child("/sun", key),
                 "\"" + std::string(key) + "\" alone is no place: give \"" + other + "\" too");
  }
  return std::nullopt;
}

SunOnMap sun_by_time(const Value& value, const std::optional<MapCentre>& centre, Report& report) {
  const Value& written = *value.find("time");
  SunTime time;
  const Result<ephemeris::Utc> utc = ephemeris::parse_utc(written.text());
  if (!utc) {
    report.error(written.place, "/sun/time", utc.diagnostics().front().message);
    return {};
  }
  time.time = *utc;
  time.place = read_place(value, report);
  if (const Value* refraction = value.find("refraction")) time.refraction = std::get<bool>(refraction->data);
  if (std::optional<SunOnMap> sun = sun_at(time, centre)) return *std::move(sun);
  if (!value.find("latitude") && !value.find("longitude")) {  // else the one that is missing has been named
    // Each key frame brings a time of its own, but the mistake is one; what --set brought is its own.
    const bool by_option = written.place.source != 0;
    report.error(by_option ? written.place : value.place, by_option ? "/sun/time" : "/sun",
                 "the place is missing: give \"latitude\" and \"longitude\" beside \"time\", in degrees; the "
                 "terrain does not say where on the earth it lies");
  }
  return {};
}

}  // namespace

Result<std::array<double, 3>> direction_of(const Value& direction) {
  std::array<double, 3> v{};
  for (std::size_t i = 0; i < v.size(); ++i) v[i] = direction.array()[i].number();
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  if (largest == 0)
    return Diagnostic{.message = "the direction has no length; expected a vector towards the sun"};
  for (double& component : v) component /= largest;  // keeps the squares from overflowing
  return v;
}

SunOnMap read_sun(const Value* value, const std::optional<MapCentre>& centre, Report& report) {
  Sun sun;
  if (!value) return {sun, {}};
  if (const Value* direction = value->find("direction")) return {sun_towards(*direction, report), {}};
  if (value->find("time")) return sun_by_time(*value, centre, report);
  if (const Value* azimuth = value->find("azimuth")) sun.azimuth = compass(azimuth->number());
  if (const Value* elevation = value->find("elevation")) sun.elevation = elevation->number();
  return {sun, {}};
}

Value canonical_sun(const Sun& sun) {
  Value value{json::Object{}};
  if (!sun.time) {
    value.set("azimuth", {sun.azimuth});
    value.set("elevation", {sun.elevation});
    return value;
  }
  value.set("time", {ephemeris::to_string(sun.time->time)});
  if (sun.time->place) {
    value.set("latitude", {sun.time->place->latitude});
    value.set("longitude", {sun.time->place->longitude});
  }
  value.set("refraction", {sun.time->refraction});
  return value;
}

}  // namespace gnomon::scene
