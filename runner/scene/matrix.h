// SPDX-License-Identifier: MIT
// The tests that a scene makes: one document for each combination of its cameras and of the values of its
// "matrix".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/edit.h"
#include "scene/frames.h"
#include "scene/json.h"
#include "scene/report.h"
#include "scene/scene.h"

namespace gnomon::scene {

/// One test's document and what tells it from its siblings.
struct Combination {
  json::Value root;               ///< without "matrix", "cameras" and "frames"
  std::string suffix;             ///< "@elevation=10,q=2", or "" where the scene makes one test
  Aliases aliases;                ///< see Report::set_aliases
  std::optional<Frame> frame;     ///< of a path
  std::vector<Problem> problems;  ///< of this one alone
};

class Matrix {
 public:
  /// `root` may hold a "matrix", whose shape has been reported on, and "cameras"; further mistakes in them go
  /// to `report`. An override wins over an axis of the same key, which then is left out.
  Matrix(json::Value root, std::vector<Override> overrides, Report& report);

  /// How many combinations there are; 1 without a matrix, some of them after an error.
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Combination `index`: cameras first, then the matrix; frames run fastest.
  [[nodiscard]] Combination at(std::size_t index) const;

  /// Whether an axis changes something below this key of the scene.
  [[nodiscard]] bool changes(const std::string& section) const;

 private:
  struct Axis {
    std::string key;
    std::string name;   ///< as in a test's id
    json::Place place;  ///< where it was written, and its JSON pointer
    std::string pointer;
    json::Array values;
    std::vector<std::string> labels;    ///< of each value, as in a test's id
    std::vector<std::string> pointers;  ///< to each value
  };

  void set_sections(std::vector<Override> overrides, Report& report);
  void read_cameras(const json::Value& cameras, Report& report);
  void read_frames(const json::Value& frames, const json::Value& cameras, Report& report);
  void read_axes(const json::Object& members, Report& report);
  void add_axis(Axis axis, Report& report);
  void drop_overridden_axes(Report& report);
  [[nodiscard]] static bool survives(const json::Value& root, const Axis& axis);
  [[nodiscard]] bool try_frames(json::Value trial, Report& report) const;
  void name_axes(Report& report);
  [[nodiscard]] std::vector<std::size_t> choices(std::size_t index) const;

  /// Of the camera axis's value `index`, as the scene spells it; "" without that axis.
  [[nodiscard]] std::string camera_name(std::size_t index) const;
  void set_frame(int frame, const std::string& camera, Combination& combination) const;

  json::Value root_;
  std::vector<Override> overrides_;
  std::vector<Axis> axes_;
  std::vector<std::string> camera_names_;
  std::optional<Frames> frames_;
  std::size_t size_ = 1;
};

}  // namespace gnomon::scene
