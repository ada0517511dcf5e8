// SPDX-License-Identifier: MIT
#include "scene/between.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "ephemeris/utc.h"
#include "scene/build_sun.h"
#include "scene/values.h"

namespace gnomon::scene {
namespace {

using json::Value;
using Vector = std::array<double, 3>;

/// Below this sine, directions are one, or opposite.
constexpr double kParallel = 1e-9;

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// From an azimuth to another one, along the shorter arc; clockwise where both arcs are half a circle.
double turn(double from, double to) {
  const double shorter = std::remainder(to - from, 360.0);
  return shorter == -180.0 ? 180.0 : shorter;
}

/// Linear between two values that are alike.
Value on_a_line(const Value& from, const Value& to, double share) {
  if (from.is_number()) return {from.number() + share * (to.number() - from.number()), to.place};
  json::Array numbers;
  for (std::size_t i = 0; i < from.array().size(); ++i)
    numbers.push_back(on_a_line(from.array()[i], to.array()[i], share));
  return {std::move(numbers), to.place};
}

std::optional<Value> in_time(const Value& from, const Value& to, Part part) {
  const std::string *start = from.get_if<std::string>(), *end = to.get_if<std::string>();
  if (!start || !end) return std::nullopt;
  const Result<ephemeris::Utc> first = ephemeris::parse_utc(*start), last = ephemeris::parse_utc(*end);
  if (!first || !last) return std::nullopt;
  return Value{ephemeris::to_string(ephemeris::between(*first, *last, part.step, part.steps)), to.place};
}

std::optional<Vector> unit(const Value& direction) {
  const Result<Vector> vector = direction_of(direction);
  if (!vector) return std::nullopt;
  const double length = std::sqrt(dot(*vector, *vector));
  return Vector{(*vector)[0] / length, (*vector)[1] / length, (*vector)[2] / length};
}

/// Two directions, the second one by its parts along the first and square to it.
struct Angle {
  Vector from;    ///< of length 1
  Vector across;  ///< square to `from`, as long as `sine`
  double cosine = 1, sine = 0;
};

std::optional<Angle> angle_between(const Value& from, const Value& to) {
  const bool is_vector = alike(from, to) && from.get_if<json::Array>() && from.array().size() == 3;
  const std::optional<Vector> a = is_vector ? unit(from) : std::nullopt;
  const std::optional<Vector> b = is_vector ? unit(to) : std::nullopt;
  if (!a || !b) return std::nullopt;
  Angle angle{*a, *b, dot(*a, *b), 0};
  for (std::size_t i = 0; i < 3; ++i) angle.across[i] -= angle.cosine * angle.from[i];
  angle.sine = std::sqrt(dot(angle.across, angle.across));
  return angle;
}

std::optional<Value> on_a_great_circle(const Value& from, const Value& to, double share) {
  const std::optional<Angle> angle = angle_between(from, to);
  if (!angle) return std::nullopt;
  if (angle->sine < kParallel) return angle->cosine > 0 ? std::optional(to) : std::nullopt;
  const double turned = share * std::atan2(angle->sine, angle->cosine);
  Vector there{};
  for (std::size_t i = 0; i < 3; ++i)
    there[i] = std::cos(turned) * angle->from[i] + std::sin(turned) * angle->across[i] / angle->sine;
  Value value = list_of(there);
  value.place = to.place;
  return value;
}

}  // namespace

bool alike(const Value& a, const Value& b) {
  const json::Array *one = a.get_if<json::Array>(), *other = b.get_if<json::Array>();
  if (!one || !other) return a.is_number() && b.is_number();
  return std::equal(one->begin(), one->end(), other->begin(), other->end(), alike);
}

std::optional<Value> between(const std::string& property, const Value& from, const Value& to, Part part) {
  const double share = double(part.step) / double(part.steps);
  if (property == "time") return in_time(from, to, part);
  if (property == "direction") return on_a_great_circle(from, to, share);
  if (!alike(from, to)) return std::nullopt;
  if (property != "azimuth") return on_a_line(from, to, share);
  if (!from.is_number()) return std::nullopt;
  return Value{from.number() + share * turn(from.number(), to.number()), to.place};
}

bool opposite(const Value& from, const Value& to) {
  const std::optional<Angle> angle = angle_between(from, to);
  return angle && angle->sine < kParallel && angle->cosine < 0;
}

}  // namespace gnomon::scene
