// SPDX-License-Identifier: MIT
// The "frames" of a scene: key frames of its camera and its sun, and what lies between them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/json.h"
#include "scene/report.h"

namespace gnomon::scene {

/// See Report::set_aliases.
using Aliases = std::vector<std::pair<std::string, std::string>>;

/// A mistake that shows in one test of a scene only; as for Report::error.
struct Problem {
  json::Place place;
  std::string pointer;
  std::string message;
};

class Frames {
 public:
  /// `written` has the shape of the schema; `cameras` are the names of the scene's cameras, none where it has
  /// one without a name. What the schema cannot say goes to `report`.
  Frames(const json::Value& written, const std::vector<std::string>& cameras, Report& report);

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] double rate() const { return rate_; }  ///< frames a second

  /// Moves the sun and the camera of a document to where they are in a frame. `camera` is the name of the
  /// camera that the document holds. Adds where the values were written to `aliases`.
  [[nodiscard]] std::vector<Problem> apply(int frame, const std::string& camera, json::Value& root,
                                           Aliases& aliases) const;

 private:
  struct Key {
    int frame = 0;
    json::Value value;
    std::string pointer;
  };
  /// One property of the sun or of a camera, through its key frames.
  struct Track {
    bool of_sun = false;
    std::string camera;    ///< its name
    std::string property;  ///< "azimuth", "time", "eye", ...
    std::vector<Key> keys;
  };

  void read_key(const json::Value& key, const std::string& pointer, const std::vector<std::string>& cameras,
                Report& report);
  void add(bool of_sun, const std::string& camera, const json::Value& properties, int frame,
           const std::string& pointer);
  const Key* move(const Track& track, int frame, const std::string& key, json::Value& root, Aliases& aliases,
                  std::vector<Problem>& problems) const;
  void move_sun(int frame, json::Value& root, Aliases& aliases, std::vector<Problem>& problems) const;
  void move_camera(int frame, const std::string& name, json::Value& root, Aliases& aliases,
                   std::vector<Problem>& problems) const;

  int count_ = 1;
  double rate_ = 0;
  std::vector<Track> tracks_;
};

/// "0007", as in a test's id.
[[nodiscard]] std::string frame_label(int frame);

}  // namespace gnomon::scene
