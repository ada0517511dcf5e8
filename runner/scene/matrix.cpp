// SPDX-License-Identifier: MIT
#include "scene/matrix.h"

#include <algorithm>
#include <charconv>

#include "scene/schema.h"
#include "scene/shape.h"

namespace gnomon::scene {
namespace {

using json::Value;

/// A suite of more tests than this is a typing error.
constexpr std::size_t kMostCombinations = 10000;
constexpr std::size_t kMostAxes = 32;
constexpr const char* kCamera = "camera";
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

bool too_many(const json::Object& axes, std::size_t combinations) {
  for (const json::Member& axis : axes) {
    combinations *= is_axis(axis.value) ? axis.value.array().size() : 1;
    if (combinations > kMostCombinations) return true;
  }
  return combinations > kMostCombinations || axes.size() > kMostAxes;
}

/// Removes a section of the scene and returns it; null where there is none.
Value take(Value& root, std::string_view section) {
  json::Object* members = root.get_if<json::Object>();
  Value* written = members ? root.find(section) : nullptr;
  if (!written) return {};
  Value taken = std::move(*written);
  std::erase_if(*members, [&](const json::Member& member) { return member.key == section; });
  return taken;
}

/// Whether a key lies in a section that makes tests, and so counts before any of them.
bool makes_tests(const Override& override) {
  const std::string section = split_key(override.key).front();
  return section == "cameras" || section == "frames";
}

/// What `take` returns for a section that the scene does not have.
bool is_absent(const Value& value) {
  return value.get_if<std::nullptr_t>() && value.place == json::Place{};
}

bool is_object(const Value& value) {
  return value.get_if<json::Object>();
}

}  // namespace

Matrix::Matrix(Value root, std::vector<Override> overrides, Report& report) : root_(std::move(root)) {
  set_sections(std::move(overrides), report);
  const Value cameras = take(root_, "cameras");
  const Value frames = take(root_, "frames");
  Value matrix = take(root_, "matrix");
  if (!is_object(matrix)) matrix.data = json::Object{};
  read_frames(frames, cameras, report);
  const std::size_t several = is_object(cameras) ? std::max<std::size_t>(cameras.object().size(), 1) : 1;
  if (too_many(matrix.object(), several * (frames_ ? std::size_t(frames_->count()) : 1))) {
    const bool by_matrix = !matrix.object().empty();
    report.error(by_matrix ? matrix.place : frames.place, by_matrix ? "/matrix" : "/frames",
                 "makes more than " + std::to_string(kMostCombinations) + " tests, or has more than " +
                     std::to_string(kMostAxes) + " keys");
  } else {
    read_cameras(cameras, report);
    read_axes(matrix.object(), report);
    drop_overridden_axes(report);
    name_axes(report);
  }
  for (const Axis& axis : axes_) size_ *= axis.values.size();
  if (frames_) size_ *= std::size_t(frames_->count());
  if (!report.ok()) size_ = std::min<std::size_t>(size_, kTriedDespiteErrors);
}

/// Sets what belongs to the sections that make tests, and keeps the other overrides for each test.
void Matrix::set_sections(std::vector<Override> overrides, Report& report) {
  for (Override& override : overrides) {
    if (!makes_tests(override)) {
      overrides_.push_back(std::move(override));
      continue;
    }
    if (split_key(override.key).front() == "cameras")
      static_cast<void>(take(root_, "camera"));  // the key decides
    if (std::optional<std::string> problem = set_value(root_, override.key, override.value))
      report.error(override.value.place, pointer_to(override.key), *problem);
  }
}

void Matrix::read_cameras(const Value& cameras, Report& report) {
  if (is_absent(cameras)) return;
  check_shape(*member_schema(scene_schema(), "cameras"), cameras, "/cameras", report);
  if (root_.find("camera")) {
    report.error(cameras.place, "/cameras",
                 "\"cameras\" does not go together with \"camera\": give one or the other");
    return;
  }
  if (!is_object(cameras) || cameras.object().empty()) return;
  Axis axis{kCamera, "", cameras.place, "/cameras", {}, {}, {}};
  for (const json::Member& camera : cameras.object()) {
    camera_names_.push_back(camera.key);
    axis.values.push_back(camera.value);
    axis.labels.push_back(as_label(camera.key));
    axis.pointers.push_back(json::child(axis.pointer, camera.key));
    if (camera.key.empty())
      report.error(camera.place, axis.pointers.back(), "expected a name for the camera");
  }
  add_axis(std::move(axis), report);
}

/// Frames of a wrong shape make no tests.
void Matrix::read_frames(const Value& frames, const Value& cameras, Report& report) {
  if (is_absent(frames)) return;
  Report shape = report.fresh();
  check_shape(*member_schema(scene_schema(), "frames"), frames, "/frames", shape);
  std::vector<std::string> names;
  for (const json::Member& camera : is_object(cameras) ? cameras.object() : json::Object{})
    names.push_back(camera.key);
  if (shape.ok()) frames_.emplace(frames, names, report);
  report.add(shape.take());
}

void Matrix::read_axes(const json::Object& members, Report& report) {
  for (const json::Member& member : members) {
    if (!is_axis(member.value)) continue;  // reported by whoever checked the shape
    Axis axis{member.key, "", member.place, json::child("/matrix", member.key), member.value.array(), {}, {}};
    std::optional<std::string> problem = key_problem(member.key);
    const std::string section = split_key(member.key).front();
    if (!problem && section == "cameras") {
      problem =
          "\"cameras\" makes tests itself; the matrix may change the camera of each, with keys of "
          "\"camera\"";
    } else if (!problem && section == "frames") {
      problem = "\"frames\" makes tests itself, the same for all values of the matrix";
    }
    if (problem) {
      report.error(member.place, axis.pointer, *problem);
      continue;
    }
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
      axis.labels.push_back(label_of(axis.values[i], i));
      axis.pointers.push_back(json::child(axis.pointer, i));
    }
    add_axis(std::move(axis), report);
  }
}

void Matrix::add_axis(Axis axis, Report& report) {
  for (std::size_t i = 0; i < axis.labels.size(); ++i) {
    const auto end = axis.labels.begin() + static_cast<std::ptrdiff_t>(i);
    const auto same = std::find(axis.labels.begin(), end, axis.labels[i]);
    if (same == end) continue;
    report.error(axis.values[i].place, axis.pointers[i],
                 "gives the same test id (\"" + axis.labels[i] + "\") as entry " +
                     std::to_string(same - axis.labels.begin()) + "; ids must differ");
  }
  axes_.push_back(std::move(axis));
}

/// Whether what the axis sets is still there, its first value having been set.
bool Matrix::survives(const Value& root, const Axis& axis) {
  const Value* value = find_value(root, axis.key);
  return value && value->place == axis.values.front().place;
}

/// Whether every axis still has a say in frame 0.
bool Matrix::try_frames(Value trial, Report& report) const {
  if (!frames_) return true;
  Aliases ignored;
  static_cast<void>(frames_->apply(0, camera_name(0), trial, ignored));
  const auto moved =
      std::find_if(axes_.begin(), axes_.end(), [&](const Axis& a) { return !survives(trial, a); });
  if (moved == axes_.end()) return true;
  report.error(moved->place, moved->pointer,
               "the key for frame 0 sets \"" + moved->key + "\" too; keep one of the two");
  return false;
}

/// Tries the first value of each axis, then the overrides: an axis whose value an override replaces or
/// removes is dropped; one that another axis or a key frame removes is an error.
void Matrix::drop_overridden_axes(Report& report) {
  Value trial = root_;
  for (const Axis& axis : axes_) {
    if (std::optional<std::string> problem = set_value(trial, axis.key, axis.values.front())) {
      report.error(axis.place, axis.pointer, *problem);
      return;
    }
  }
  const auto removed =
      std::find_if(axes_.begin(), axes_.end(), [&](const Axis& a) { return !survives(trial, a); });
  if (removed != axes_.end()) {
    report.error(
        removed->place, removed->pointer,
        "a later axis of the matrix removes or replaces \"" + removed->key + "\"; keep one of the two");
    return;
  }
  if (!try_frames(trial, report)) return;
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
    // Axes of one key are "cameras" and a matrix over "camera": reported already.
    const auto clashes = [&](const Axis& other) {
      return other.name == axis->name && other.key != axis->key;
    };
    if (std::none_of(axes_.begin(), axis, clashes)) continue;
    report.error(axis->place, axis->pointer,
                 "gives the same test ids (\"" + axis->name + "\") as another axis; ids must differ");
  }
}

std::string Matrix::camera_name(std::size_t index) const {
  if (camera_names_.empty() || axes_.empty() || axes_.front().key != kCamera) return "";
  return camera_names_[index];
}

std::vector<std::size_t> Matrix::choices(std::size_t index) const {
  std::vector<std::size_t> chosen(axes_.size());
  for (std::size_t i = axes_.size(); i-- > 0;) {
    chosen[i] = index % axes_[i].values.size();
    index /= axes_[i].values.size();
  }
  return chosen;
}

void Matrix::set_frame(int frame, const std::string& camera, Combination& combination) const {
  combination.problems = frames_->apply(frame, camera, combination.root, combination.aliases);
  combination.suffix += (combination.suffix.empty() ? "@" : ",") + std::string("frame=") + frame_label(frame);
  combination.frame = Frame{.number = frame, .count = frames_->count(), .rate = frames_->rate()};
}

Combination Matrix::at(std::size_t index) const {
  const std::size_t frames = frames_ ? std::size_t(frames_->count()) : 1;
  Combination combination{.root = root_};
  const std::vector<std::size_t> chosen = choices(index / frames);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const Axis& axis = axes_[i];
    // The constructor has tried every key; only the shape of a value may still be wrong.
    static_cast<void>(set_value(combination.root, axis.key, axis.values[chosen[i]]));
    combination.suffix += (i == 0 ? "@" : ",") + axis.name + "=" + axis.labels[chosen[i]];
    combination.aliases.emplace_back(pointer_to(axis.key), axis.pointers[chosen[i]]);
  }
  if (frames_) set_frame(int(index % frames), chosen.empty() ? "" : camera_name(chosen.front()), combination);
  for (const Override& override : overrides_) {
    static_cast<void>(set_value(combination.root, override.key, override.value));
  }
  return combination;
}

bool Matrix::changes(const std::string& section) const {
  if (frames_ && (section == "sun" || section == kCamera)) return true;
  return std::any_of(axes_.begin(), axes_.end(),
                     [&](const Axis& axis) { return split_key(axis.key).front() == section; });
}

}  // namespace gnomon::scene
