// SPDX-License-Identifier: MIT
#include "scene/frames.h"

#include <algorithm>
#include <optional>

#include "ephemeris/utc.h"
#include "scene/between.h"
#include "scene/build_sun.h"
#include "scene/edit.h"
#include "scene/schema.h"
#include "scene/suggest.h"
#include "scene/values.h"

namespace gnomon::scene {
namespace {

using json::child;
using json::Value;

/// What the scene says of a key, or the schema's default.
const Value* written_or_default(const Value& root, const std::string& key) {
  static const Value kNothing{json::Object{}};
  if (const Value* written = find_value(root, key)) return written;
  const Value* node = &scene_schema();
  const Value* at = &root;
  for (const std::string& part : split_key(key)) {
    const Value* alternative = choose_alternative(*node, *at);
    node = alternative ? member_schema(*alternative, part) : nullptr;
    if (!node) return nullptr;
    const Value* inside = at->find(part);
    at = inside ? inside : &kNothing;
  }
  return resolve(*node).find("default");
}

/// Whether the section of `root`, if it is of a sound shape, may hold `key`.
bool may_hold(const Value& root, const char* section, const std::string& key) {
  static const Value kNothing{json::Object{}};
  const Value* value = root.find(section);
  const Value* alternative =
      choose_alternative(*member_schema(scene_schema(), section), value ? *value : kNothing);
  return !alternative || member_schema(*alternative, key);
}

/// How a sun is given that has this property.
std::string given_by(const std::string& property) {
  const bool is_angle = property == "azimuth" || property == "elevation";
  return is_angle ? R"("azimuth" and "elevation")" : "\"" + property + "\"";
}

/// Why frames cannot move this property of the scene's sun, which is given in another way.
std::string unfit_for_sun(const Value& root, const std::string& property) {
  const Value* sun = root.find("sun");
  const std::string needed = "\"" + property + "\" moves a sun that is given by " + given_by(property);
  if (!sun || sun->object().empty())
    return needed + ", and the scene says nothing of its sun: write \"sun\": {" + given_by(property) +
           ": ...} for frame 0";
  const std::string written = sun->find("direction") ? "direction" : sun->find("time") ? "time" : "azimuth";
  return needed + ", and the scene gives its sun by " + given_by(written) + ": give both in the same way";
}

/// What is wrong with a key's value of the sun that the schema does not say.
std::optional<std::string> mistake_in(const json::Member& property) {
  if (property.key == "time") {
    const Result<ephemeris::Utc> time = ephemeris::parse_utc(property.value.text());
    if (!time) return time.diagnostics().front().message;
  } else if (property.key == "direction") {
    const Result<std::array<double, 3>> direction = direction_of(property.value);
    if (!direction) return direction.diagnostics().front().message;
  }
  return std::nullopt;
}

/// "perspective" or "orthographic", or nothing for cameras that stand nowhere.
std::optional<std::string> view_of(const Value& root) {
  const Value* camera = root.find("camera");
  for (const char* view : {"perspective", "orthographic"}) {
    if (camera && camera->find(view)) return view;
  }
  return std::nullopt;
}

/// Why frames cannot move this property of a camera.
std::optional<std::string> unfit_for(const Value& camera, const std::optional<std::string>& view,
                                     const std::string& property) {
  if (!view) return "only a perspective or orthographic camera can be moved";
  const Value* alternative = choose_alternative(*member_schema(scene_schema(), "camera"), camera);
  const Value* inside = alternative ? member_schema(*alternative, *view) : nullptr;
  if (!inside || member_schema(*inside, property)) return std::nullopt;
  return "this camera is " + *view + " and has no \"" + property + "\"";
}

bool eye_meets_target(const Value& view) {
  const Value *eye = view.find("eye"), *target = view.find("target");
  if (!eye || !target || !eye->get_if<json::Array>() || !alike(*eye, *target)) return false;
  return std::equal(eye->array().begin(), eye->array().end(), target->array().begin(),
                    [](const Value& a, const Value& b) { return a.number() == b.number(); });
}

}  // namespace

std::string frame_label(int frame) {
  const std::string digits = std::to_string(frame);
  return std::string(digits.size() < 4 ? 4 - digits.size() : 0, '0') + digits;
}

Frames::Frames(const Value& written, const std::vector<std::string>& cameras, Report& report)
    : count_(integer_of(*written.find("count"))) {
  const Value* rate = written.find("rate");
  rate_ = (rate ? rate : member_schema(*member_schema(scene_schema(), "frames"), "rate")->find("default"))
              ->number();
  const json::Array& keys = written.find("keys")->array();
  int last = -1;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const std::string pointer = child("/frames/keys", i);
    const Value& frame = *keys[i].find("frame");
    if (integer_of(frame) >= count_) {
      report.error(frame.place, child(pointer, "frame"),
                   "there is no such frame; with a count of " + std::to_string(count_) + " the last one is " +
                       std::to_string(count_ - 1));
    } else if (integer_of(frame) <= last) {
      report.error(
          frame.place, child(pointer, "frame"),
          "frames have to rise from key to key; the key before is for frame " + std::to_string(last));
    }
    last = std::max(last, integer_of(frame));
    read_key(keys[i], pointer, cameras, report);
  }
}

void Frames::read_key(const Value& key, const std::string& pointer, const std::vector<std::string>& cameras,
                      Report& report) {
  const int frame = integer_of(*key.find("frame"));
  bool moves = false;
  for (const json::Member& member : key.object()) {
    const std::string inside = child(pointer, member.key);
    if (member.key == "sun") {
      add(true, "", member.value, frame, inside);
      for (const json::Member& property : member.value.object()) {
        if (const std::optional<std::string> mistake = mistake_in(property))
          report.error(property.value.place, child(inside, property.key), *mistake);
      }
    } else if (member.key == "camera") {
      add(false, "", member.value, frame, inside);
      if (!cameras.empty())
        report.error(member.place, inside,
                     "the scene has several cameras; say which one: \"cameras\": {NAME: ...}");
    } else if (member.key == "cameras") {
      for (const json::Member& camera : member.value.object()) {
        add(false, camera.key, camera.value, frame, child(inside, camera.key));
        if (cameras.empty()) {
          report.error(member.place, inside,
                       "the scene has one camera without a name; write \"camera\": {...}");
        } else if (std::find(cameras.begin(), cameras.end(), camera.key) == cameras.end()) {
          report.error(camera.place, child(inside, camera.key), unknown_name("camera", camera.key, cameras));
        }
      }
    } else {
      continue;
    }
    moves = moves || !member.value.object().empty();
  }
  if (!moves)
    report.error(key.place, pointer,
                 "the key moves nothing; expected \"sun\", \"camera\" or \"cameras\" with what changes");
}

void Frames::add(bool of_sun, const std::string& camera, const Value& properties, int frame,
                 const std::string& pointer) {
  for (const json::Member& property : properties.object()) {
    auto track = std::find_if(tracks_.begin(), tracks_.end(), [&](const Track& known) {
      return known.of_sun == of_sun && known.camera == camera && known.property == property.key;
    });
    if (track == tracks_.end()) track = tracks_.insert(track, Track{of_sun, camera, property.key, {}});
    track->keys.push_back({frame, property.value, child(pointer, property.key)});
  }
}

/// Before its first key a property comes from what the scene says of it, which stands for frame 0; after the
/// last one it stays. Returns the key that the value was taken from or is on its way to; null where the
/// scene's own value stands.
const Frames::Key* Frames::move(const Track& track, int frame, const std::string& key, Value& root,
                                Aliases& aliases, std::vector<Problem>& problems) const {
  const auto next =
      std::find_if(track.keys.begin(), track.keys.end(), [&](const Key& k) { return k.frame >= frame; });
  const Key& target = next == track.keys.end() ? track.keys.back() : *next;
  Value value = target.value;
  if (target.frame > frame) {
    const bool from_scene = next == track.keys.begin();
    const Value* start = from_scene ? written_or_default(root, key) : &std::prev(next)->value;
    const int start_frame = from_scene ? 0 : std::prev(next)->frame;
    if (!start || frame == start_frame) return nullptr;
    if (track.property == "direction" && opposite(*start, target.value)) {
      problems.push_back({target.value.place, target.pointer,
                          "this direction is opposite to the one before it, and no way between them is the "
                          "shortest; tell the way with a key between"});
    }
    // What is wrong with the scene's own value is said where all of it is checked.
    std::optional<Value> on_the_way =
        between(track.property, *start, target.value, {frame - start_frame, target.frame - start_frame});
    if (!on_the_way) return nullptr;
    value = *std::move(on_the_way);
  }
  if (set_value(root, key, value)) return nullptr;  // likewise
  aliases.emplace_back(pointer_to(key), target.pointer);
  return &target;
}

void Frames::move_sun(int frame, Value& root, Aliases& aliases, std::vector<Problem>& problems) const {
  for (const Track& track : tracks_) {
    if (!track.of_sun) continue;
    if (may_hold(root, "sun", track.property)) {
      move(track, frame, "sun." + track.property, root, aliases, problems);
      continue;
    }
    for (const Key& key : track.keys)
      problems.push_back({key.value.place, key.pointer, unfit_for_sun(root, track.property)});
  }
}

void Frames::move_camera(int frame, const std::string& name, Value& root, Aliases& aliases,
                         std::vector<Problem>& problems) const {
  const std::optional<std::string> view = view_of(root);
  const Value* standing = root.find("camera");
  const Value before = standing ? *standing : Value{json::Object{}};
  const Key* moved = nullptr;
  for (const Track& track : tracks_) {
    if (track.of_sun || track.camera != name) continue;
    if (const std::optional<std::string> unfit = unfit_for(before, view, track.property)) {
      problems.push_back({track.keys.front().value.place, track.keys.front().pointer, *unfit});
    } else if (const Key* key =
                   move(track, frame, "camera." + *view + "." + track.property, root, aliases, problems)) {
      moved = key;
    }
  }
  if (!moved || !eye_meets_target(*root.find("camera")->find(*view))) return;
  problems.push_back(
      {moved->value.place, moved->pointer,
       "in frame " + std::to_string(frame) +
           " the camera's eye and target are the same point; keep them apart with a key between"});
  root.set("camera", before);
}

std::vector<Problem> Frames::apply(int frame, const std::string& camera, Value& root,
                                   Aliases& aliases) const {
  std::vector<Problem> problems;
  move_sun(frame, root, aliases, problems);
  move_camera(frame, camera, root, aliases, problems);
  return problems;
}

}  // namespace gnomon::scene
