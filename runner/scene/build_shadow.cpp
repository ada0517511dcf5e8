// SPDX-License-Identifier: MIT
#include "scene/build_shadow.h"

#include <array>

#include "scene/values.h"

namespace gnomon::scene {
namespace {

using json::Value;

constexpr std::array kFaces{"all", "front", "back"};  // by Cascades::Faces

Cascades read_cascades(const Value& value) {
  Cascades cascades;
  read_integer(value, "count", cascades.count);
  read_integer(value, "size", cascades.size);
  read_integer(value, "filter", cascades.filter);
  read_integer(value, "step", cascades.step);
  read_number(value, "split", cascades.split);
  read_number(value, "bias", cascades.bias);
  read_number(value, "slope_bias", cascades.slope_bias);
  if (const Value* distance = value.find("distance")) cascades.distance = distance->number();
  if (const Value* stable = value.find("stable")) cascades.stable = std::get<bool>(stable->data);
  if (const Value* faces = value.find("faces")) {
    for (std::size_t i = 0; i < kFaces.size(); ++i)
      if (faces->text() == kFaces[i]) cascades.faces = static_cast<Cascades::Faces>(i);
  }
  return cascades;
}

Value canonical_cascades(const Cascades& cascades) {
  Value value{json::Object{}};
  value.set("count", {std::int64_t{cascades.count}});
  value.set("size", {std::int64_t{cascades.size}});
  value.set("filter", {std::int64_t{cascades.filter}});
  value.set("step", {std::int64_t{cascades.step}});
  value.set("split", {cascades.split});
  value.set("bias", {cascades.bias});
  value.set("slope_bias", {cascades.slope_bias});
  if (cascades.distance) value.set("distance", {*cascades.distance});
  value.set("stable", {cascades.stable});
  value.set("faces", {std::string(kFaces[static_cast<std::size_t>(cascades.faces)])});
  return value;
}

}  // namespace

Shadow read_shadow(const Value* value, const Vocabulary& vocabulary, Report& report) {
  Shadow shadow;
  if (!value) return shadow;
  if (const Value* method = value->find("method")) {
    shadow.method = method->text();
    check_name("shadow method", shadow.method, vocabulary.methods, method->place, "/shadow/method", report);
  }
  if (const Value* q = value->find("q")) {
    shadow.q = q->get_if<std::string>() ? std::nullopt : std::optional(integer_of(*q));  // else "auto"
  }
  read_integer(*value, "max_anisotropy", shadow.max_anisotropy);
  read_number(*value, "k_dark", shadow.k_dark);
  read_number(*value, "k_bright", shadow.k_bright);
  read_number(*value, "receiver_height", shadow.receiver_height);
  if (const Value* cascades = value->find("cascades")) shadow.cascades = read_cascades(*cascades);
  return shadow;
}

Value canonical_shadow(const Shadow& shadow) {
  Value value{json::Object{}};
  value.set("method", {shadow.method});
  value.set("k_dark", {shadow.k_dark});
  value.set("k_bright", {shadow.k_bright});
  value.set("receiver_height", {shadow.receiver_height});
  if (shadow.q) {
    value.set("q", {std::int64_t{*shadow.q}});
  } else {
    value.set("q", {std::string("auto")});
    value.set("max_anisotropy", {std::int64_t{shadow.max_anisotropy}});
  }
  if (shadow.method == "cascaded_shadow_maps") value.set("cascades", canonical_cascades(shadow.cascades));
  return value;
}

}  // namespace gnomon::scene
