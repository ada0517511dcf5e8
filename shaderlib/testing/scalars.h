// SPDX-License-Identifier: MIT
// Values of the modules' types as lists of scalars and as GLSL text. A scalar travels as a float: booleans
// as 0 and 1, integers as themselves (below 2^24 exactly).
#ifndef GNOMON_TESTING_SCALARS_H
#define GNOMON_TESTING_SCALARS_H

#include <gnomon/modules.h>

#include <concepts>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace gnomon::modules {

// The members of each structure in their order: what a constructor in GLSL takes.
template <class V>
void visit_members(Modules::GnomonMap& map, V&& visit) {
  visit("size", map.size);
  visit("domain", map.domain);
  visit("spacing", map.spacing);
  visit("highest", map.highest);
  visit("top_level", map.top_level);
}
template <class V>
void visit_members(Modules::GnomonReceiver& receiver, V&& visit) {
  visit("patch_index", receiver.patch_index);
  visit("fraction", receiver.fraction);
  visit("height", receiver.height);
}
template <class V>
void visit_members(Modules::GnomonRay& ray, V&& visit) {
  visit("start", ray.start);
  visit("fraction", ray.fraction);
  visit("direction", ray.direction);
  visit("inverse", ray.inverse);
  visit("forward", ray.forward);
  visit("rise", ray.rise);
  visit("base", ray.base);
  visit("height", ray.height);
  visit("t_end", ray.t_end);
}
template <class V>
void visit_members(Modules::GnomonPatch& patch, V&& visit) {
  visit("origin", patch.origin);
  visit("slope", patch.slope);
  visit("twist", patch.twist);
  visit("hole", patch.hole);
}
template <class V>
void visit_members(Modules::GnomonCrossing& crossing, V&& visit) {
  visit("slope", crossing.slope);
  visit("curvature", crossing.curvature);
  visit("above", crossing.above);
  visit("hole", crossing.hole);
}
template <class V>
void visit_members(Modules::GnomonCursor& cursor, V&& visit) {
  visit("patch_index", cursor.patch_index);
  visit("t", cursor.t);
  visit("steps", cursor.steps);
  visit("cause", cursor.cause);
  visit("after_hole", cursor.after_hole);
  visit("met_hole", cursor.met_hole);
}
template <class V>
void visit_members(Modules::GnomonTransit& transit, V&& visit) {
  visit("t", transit.t);
  visit("offset", transit.offset);
}
template <class V>
void visit_members(Modules::GnomonTrack& track, V&& visit) {
  visit("start", track.start);
  visit("height", track.height);
  visit("direction", track.direction);
  visit("to_sun", track.to_sun);
}
template <class V>
void visit_members(Modules::GnomonShadow& shadow, V&& visit) {
  visit("shadow", shadow.shadow);
  visit("steps", shadow.steps);
  visit("cause", shadow.cause);
}
template <class V>
void visit_members(Modules::GnomonSpan& span, V&& visit) {
  visit("first", span.first);
  visit("last", span.last);
}
template <class V>
void visit_members(Modules::GnomonHit& hit, V&& visit) {
  visit("at", hit.at);
  visit("depth", hit.depth);
  visit("steps", hit.steps);
  visit("cause", hit.cause);
}
template <class V>
void visit_members(Modules::GnomonGridPoint& point, V&& visit) {
  visit("height", point.height);
  visit("normal", point.normal);
  visit("hole", point.hole);
}
template <class V>
void visit_members(Modules::GnomonCascade& cascade, V&& visit) {
  visit("corner", cascade.corner);
  visit("texel", cascade.texel);
}
template <class V>
void visit_members(Modules::GnomonLight& light, V&& visit) {
  visit("origin", light.origin);
  visit("right", light.right);
  visit("down", light.down);
  visit("range", light.range);
  visit("size", light.size);
  visit("cascades", light.cascades);
  visit("grid_step", light.grid_step);
  visit("bias", light.bias);
  visit("slope_bias", light.slope_bias);
  visit("filter_width", light.filter_width);
  visit("cascade", light.cascade);
}
template <class T, std::size_t N, class V>
void visit_members(T (&list)[N], V&& visit) {
  for (T& element : list) visit("", element);
}
template <glm::length_t N, class T, class V>
void visit_members(glm::vec<N, T>& vector, V&& visit) {
  constexpr const char* kNames[] = {"x", "y", "z", "w"};
  for (glm::length_t i = 0; i < N; ++i) visit(kNames[i], vector[i]);
}

template <class T>
concept Scalar = std::same_as<T, bool> || std::same_as<T, int> || std::same_as<T, float>;

/// How GLSL spells a type.
template <class T>
[[nodiscard]] std::string glsl_name() {
  if constexpr (std::is_array_v<T>)
    return glsl_name<std::remove_extent_t<T>>() + "[" + std::to_string(std::extent_v<T>) + "]";
  if constexpr (std::same_as<T, bool>) return "bool";
  if constexpr (std::same_as<T, int>) return "int";
  if constexpr (std::same_as<T, float>) return "float";
  if constexpr (std::same_as<T, ivec2>) return "ivec2";
  if constexpr (std::same_as<T, vec2>) return "vec2";
  if constexpr (std::same_as<T, vec3>) return "vec3";
  if constexpr (std::same_as<T, Modules::GnomonMap>) return "GnomonMap";
  if constexpr (std::same_as<T, Modules::GnomonReceiver>) return "GnomonReceiver";
  if constexpr (std::same_as<T, Modules::GnomonRay>) return "GnomonRay";
  if constexpr (std::same_as<T, Modules::GnomonPatch>) return "GnomonPatch";
  if constexpr (std::same_as<T, Modules::GnomonCrossing>) return "GnomonCrossing";
  if constexpr (std::same_as<T, Modules::GnomonCursor>) return "GnomonCursor";
  if constexpr (std::same_as<T, Modules::GnomonTransit>) return "GnomonTransit";
  if constexpr (std::same_as<T, Modules::GnomonTrack>) return "GnomonTrack";
  if constexpr (std::same_as<T, Modules::GnomonShadow>) return "GnomonShadow";
  if constexpr (std::same_as<T, Modules::GnomonSpan>) return "GnomonSpan";
  if constexpr (std::same_as<T, Modules::GnomonHit>) return "GnomonHit";
  if constexpr (std::same_as<T, Modules::GnomonGridPoint>) return "GnomonGridPoint";
  if constexpr (std::same_as<T, Modules::GnomonCascade>) return "GnomonCascade";
  if constexpr (std::same_as<T, Modules::GnomonLight>) return "GnomonLight";
}

/// Calls visit(scalar&) for every scalar of a value.
template <class T, class V>
void visit_scalars(T& value, V&& visit) {
  if constexpr (Scalar<T>)
    visit(value);
  else
    visit_members(value, [&](const char*, auto& member) { visit_scalars(member, visit); });
}

template <class T>
void append_scalars(T value, std::vector<float>& scalars) {
  visit_scalars(value, [&](auto& scalar) { scalars.push_back(static_cast<float>(scalar)); });
}

/// Takes a value off the beginning of `scalars`.
template <class T>
[[nodiscard]] T take_scalars(std::span<const float>& scalars) {
  T value{};
  visit_scalars(value, [&](auto& scalar) {
    scalar = static_cast<std::remove_reference_t<decltype(scalar)>>(scalars.front());
    scalars = scalars.subspan(1);
  });
  return value;
}

/// A GLSL expression that makes a T of the scalars argument(next), argument(next + 1) ...
template <class T>
[[nodiscard]] std::string construct_in_glsl(int& next) {
  if constexpr (std::same_as<T, bool>) return "(argument(" + std::to_string(next++) + ") != 0.0)";
  if constexpr (Scalar<T>) return glsl_name<T>() + "(argument(" + std::to_string(next++) + "))";
  std::string parts;
  if constexpr (!Scalar<T>) {
    T value{};
    visit_members(value, [&](const char*, auto& member) {
      parts +=
          (parts.empty() ? "" : ", ") + construct_in_glsl<std::remove_reference_t<decltype(member)>>(next);
    });
  }
  return glsl_name<T>() + "(" + parts + ")";
}

/// GLSL expressions, each a float, for the scalars of the value called `name`.
template <class T>
void append_glsl_scalars(const std::string& name, std::vector<std::string>& expressions) {
  if constexpr (Scalar<T>) {
    expressions.push_back("float(" + name + ")");
  } else {
    T value{};
    visit_members(value, [&](const char* part, auto& member) {
      append_glsl_scalars<std::remove_reference_t<decltype(member)>>(name + "." + part, expressions);
    });
  }
}

}  // namespace gnomon::modules

#endif
