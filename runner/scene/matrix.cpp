// SPDX-License-Identifier: MIT
#include "scene/matrix.h"

#include <algorithm>
#include <charconv>

namespace gnomon::scene {
namespace {

using json::Value;

/// A suite of more tests than this is a typing error.
constexpr std::size_t kMostCombinations = 10000;
constexpr std::size_t kMostAxes = 32;
/// After a mistake in the matrix or the overrides no test is made: enough to find most further mistakes.
constexpr std::size_t kTriedDespiteErrors = 100;

bool is_label_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '.' || c == '+';
}

/// Fit for a test id and a file name: any other character (not byte) becomes "_".
std::string as_label(const std::string& text) {
  std::string label;
  for (const char c : text) {
    if (is_label_character(c)) {
      label += c;
    } else if ((static_cast<unsigned char>(c) & 0xC0U) != 0x80U) {  // the first byte of a UTF-8 character
      label += '_';
    }
  }
  return label;
}

std::string label_of(const Value& value, std::size_t index) {
  char number[32];
  if (const std::int64_t* integer = value.get_if<std::int64_t>()) {
    return {number, std::to_chars(number, number + sizeof number, *integer).ptr};
  }
  if (const double* decimal = value.get_if<double>()) {
    return {number, std::to_chars(number, number + sizeof number, *decimal).ptr};
  }
  if (const std::string* text = value.get_if<std::string>()) return as_label(*text);
  if (value.get_if<json::Array>() || value.get_if<json::Object>()) return "#" + std::to_string(index);
  return dump(value);  // true, false, null
}

bool is_axis(const Value& value) {
  const json::Array* values = value.get_if<json::Array>();
  return values && !values->empty();
}

bool too_many(const json::Object& axes) {
  std::size_t combinations = 1;
  for (const json::Member& axis : axes) {
    combinations *= is_axis(axis.value) ? axis.value.array().size() : 1;
    if (combinations > kMostCombinations) return true;
  }
  return axes.size() > kMostAxes;
}

}  // namespace

Matrix::Matrix(Value root, std::vector<Override> overrides, Report& report)
    : root_(std::move(root)), overrides_(std::move(overrides)) {
  json::Value matrix{json::Object{}};
  if (json::Object* members = root_.get_if<json::Object>()) {
    if (const Value* written = root_.find("matrix"); written && written->get_if<json::Object>())
      matrix = *written;
    std::erase_if(*members, [](const json::Member& member) { return member.key == "matrix"; });
  }
  if (too_many(matrix.object())) {
    report.error(matrix.place, "/matrix",
                 "makes more than " + std::to_string(kMostCombinations) + " tests, or has more than " +
                     std::to_string(kMostAxes) + " keys");
  } else {
    read_axes(matrix.object(), report);
    drop_overridden_axes(report);
    name_axes(report);
  }
  for (const Axis& axis : axes_) size_ *= axis.values.size();
  if (!report.ok()) size_ = std::min<std::size_t>(size_, kTriedDespiteErrors);
}

void Matrix::read_axes(const json::Object& members, Report& report) {
  for (const json::Member& member : members) {
    if (!is_axis(member.value)) continue;  // reported by whoever checked the shape
    if (std::optional<std::string> problem = key_problem(member.key)) {
      report.error(member.place, json::child("/matrix", member.key), *problem);
      continue;
    }
    Axis axis{member.key, "", member.place, member.value.array(), {}};
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
      axis.labels.push_back(label_of(axis.values[i], i));
      const auto same = std::find(axis.labels.begin(), axis.labels.end() - 1, axis.labels.back());
      if (same == axis.labels.end() - 1) continue;
      report.error(axis.values[i].place, json::child(json::child("/matrix", member.key), i),
                   "gives the same test id (\"" + axis.labels.back() + "\") as entry " +
                       std::to_string(same - axis.labels.begin()) + "; ids must differ");
    }
    axes_.push_back(std::move(axis));
  }
}

/// Tries the first value of each axis, then the overrides: an axis whose value an override replaces or
/// removes is dropped; one that another axis removes is an error.
void Matrix::drop_overridden_axes(Report& report) {
  const auto survives = [](const Value& root, const Axis& axis) {
    const Value* value = find_value(root, axis.key);
    return value && value->place == axis.values.front().place;
  };
  Value trial = root_;
  for (const Axis& axis : axes_) {
    if (std::optional<std::string> problem = set_value(trial, axis.key, axis.values.front())) {
      report.error(axis.key_place, json::child("/matrix", axis.key), *problem);
      return;
    }
  }
  const auto removed =
      std::find_if(axes_.begin(), axes_.end(), [&](const Axis& a) { return !survives(trial, a); });
  if (removed != axes_.end()) {
    report.error(
        removed->key_place, json::child("/matrix", removed->key),
        "a later axis of the matrix removes or replaces \"" + removed->key + "\"; keep one of the two");
    return;
  }
  for (const Override& override : overrides_) {
    if (std::optional<std::string> problem = set_value(trial, override.key, override.value)) {
      report.error(override.value.place, pointer_to(override.key), *problem);
    }
  }
  std::erase_if(axes_, [&](const Axis& axis) { return !survives(trial, axis); });
}

/// The last part of each key; the whole key where two would be alike.
void Matrix::name_axes(Report& report) {
  const auto last_part = [](const Axis& axis) { return as_label(split_key(axis.key).back()); };
  for (Axis& axis : axes_) {
    const std::string name = last_part(axis);
    const auto alike =
        std::count_if(axes_.begin(), axes_.end(), [&](const Axis& a) { return last_part(a) == name; });
    axis.name = alike > 1 ? as_label(axis.key) : name;
  }
  for (auto axis = axes_.begin(); axis != axes_.end(); ++axis) {
    if (std::none_of(axes_.begin(), axis, [&](const Axis& other) { return other.name == axis->name; }))
      continue;
    report.error(axis->key_place, json::child("/matrix", axis->key),
                 "gives the same test ids (\"" + axis->name + "\") as another axis; ids must differ");
  }
}

std::vector<std::size_t> Matrix::choices(std::size_t index) const {
  std::vector<std::size_t> chosen(axes_.size());
  for (std::size_t i = axes_.size(); i-- > 0;) {
    chosen[i] = index % axes_[i].values.size();
    index /= axes_[i].values.size();
  }
  return chosen;
}

Combination Matrix::at(std::size_t index) const {
  Combination combination{root_, "", {}};
  const std::vector<std::size_t> chosen = choices(index);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Axis& axis = axes_[i];
    // The constructor has tried every key; only the shape of a value may still be wrong.
    static_cast<void>(set_value(combination.root, axis.key, axis.values[chosen[i]]));
    combination.suffix += (i == 0 ? "@" : ",") + axis.name + "=" + axis.labels[chosen[i]];
    combination.aliases.emplace_back(pointer_to(axis.key),
                                     json::child(json::child("/matrix", axis.key), chosen[i]));
  }
  for (const Override& override : overrides_) {
    static_cast<void>(set_value(combination.root, override.key, override.value));
  }
  return combination;
}

bool Matrix::changes(const std::string& section) const {
  return std::any_of(axes_.begin(), axes_.end(),
                     [&](const Axis& axis) { return split_key(axis.key).front() == section; });
}

}  // namespace gnomon::scene
